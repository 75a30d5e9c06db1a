#include "analysis/mechanism/circuit_range.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/mechanism/output_limits.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

/// Parts of the scale of the drive: ends of branches closer than this are one.
constexpr double kSameRange = 1e-6;
/// Of a whole turn: farther than rounding moves a dead point.
constexpr double kBefore = 1e-11;
/// A crank that turns on and on has been everywhere before: a group has no more assemblies.
constexpr int kMostTurns = 6;
/// Of the way to a dead point.
constexpr double kNearEnd = 1e-2;
/// No circuit of a mechanism worth following has more branches.
constexpr int kMostBranches = 64;

void set_sides(Mechanism<double>& mechanism, const std::vector<double>& sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Assembly assembly = sides[i] < 0 ? Assembly::crossed : Assembly::open;
    const auto set = [&](auto& dyad) {
      if constexpr (requires { dyad.assembly; }) dyad.assembly = assembly;
    };
    std::visit(set, mechanism.dyads[i]);
  }
}

/// The motion from one dead point, or from within a branch, to the next.
struct Branch {
  AssemblyRanges assembly_ranges;  ///< with the one run
  double end = 0;
  int dyad = -1;  ///< that ends it; −1: none within a turn

  const AssemblyRange& run() const { return assembly_ranges.runs.front(); }
};

/// Draws the groups of a mechanism where they stand in `run`.
void draw_groups(Mechanism<double>& mechanism, const AssemblyRange& run, double drive) {
  std::vector<BodyMotion<double, 0>> bodies(static_cast<std::size_t>(body_count(mechanism)));
  place_groups(run, drive, std::span(bodies));
  for (int i = 0; i < static_cast<int>(mechanism.dyads.size()); ++i) {
    auto* group = std::get_if<Group>(&mechanism.dyads[static_cast<std::size_t>(i)]);
    if (!group) continue;
    group->drive = drive;
    auto body = bodies.begin() + first_body(mechanism, i);
    for (Placement& drawn : group->drawn) drawn = {body->origin[0], (body++)->direction};
  }
}

/// Draws the group at `dyad` on the other side of its dead point, which ends `run` at its lesser or
/// greater end. False where that is not known.
bool draw_beyond(Mechanism<double>& mechanism, const AssemblyRange& run, int dyad, bool at_from) {
  const auto count =
      std::count_if(mechanism.dyads.begin(), mechanism.dyads.begin() + dyad,
                    [](const Dyad<double>& other) { return std::holds_alternative<Group>(other); });
  const auto& beyond = run.tracks[static_cast<std::size_t>(count)]->beyond()[at_from ? 0 : 1];
  if (!beyond) return false;
  Group& group = std::get<Group>(mechanism.dyads[static_cast<std::size_t>(dyad)]);
  group.drive = beyond->drive;
  group.drawn = beyond->bodies;
  return true;
}

/// Goes through the branches of a circuit.
class Circuit {
 public:
  Circuit(Mechanism<double> mechanism, const Travel& travel, const std::function<bool()>& stop)
      : mechanism_(std::move(mechanism)), travel_(travel), stop_(stop) {}

  std::optional<CircuitRange> from(double drive, const std::vector<double>& sides) {
    const auto back = branch(drive, -1, sides);
    if (!back) return std::nullopt;
    if (back->dyad < 0) return over_turns(drive, sides);
    // Near the end, so that they are drawn in the turn in which the way back begins.
    draw_groups(mechanism_, back->run(), std::lerp(back->end, drive, kNearEnd));
    return round(*back);
  }

 private:
  bool turns() const { return !driven_by_length(mechanism_.drive); }

  /// Farther than a driving slider can go.
  double reach(double drive) const {
    if (turns()) return kTurn;
    MechanismMotion<0> motion(mechanism_);
    double size = 0;
    if (!motion.move_to(drive)) return size;
    for (const auto& a : motion.bodies()) {
      for (const auto& b : motion.bodies()) size = std::max(size, norm(a.origin[0] - b.origin[0]));
    }
    return 4 * size;
  }

  std::optional<Branch> branch(double start, int sense, const std::vector<double>& sides) {
    set_sides(mechanism_, sides);
    if (reach_ == 0) reach_ = reach(start);
    if (!(reach_ > 0)) return std::nullopt;
    auto found = branch_within(start, sense * reach_);
    if (!found || found->dyad >= 0) return found;
    const AssemblyRange& run = found->run();
    const bool is_round = groups_stand_alike(mechanism_, run, run.from, run, run.to);
    return is_round ? found : branch_within(start, sense * kMostTurns * reach_);
  }

  std::optional<Branch> branch_within(double start, double way) {
    const int sense = way > 0 ? 1 : -1;
    // A little before the start, so that the dead point there ends the run, regardless of rounding.
    const double before = start - kBefore * way;
    Branch branch{follow(mechanism_, before, start + way, stop_)};
    if (branch.assembly_ranges.runs.empty() || (stop_ && stop_())) return std::nullopt;
    const auto distance = [&](const AssemblyRange& run) {
      return std::abs((sense > 0 ? run.from : run.to) - start);
    };
    AssemblyRange run =
        std::move(*std::ranges::min_element(branch.assembly_ranges.runs, {}, distance));
    const double begins = sense > 0 ? run.from : run.to;
    scale_ = branch.assembly_ranges.scale;
    if (std::abs(begins - start) > kSameRange * scale_) return std::nullopt;
    branch.end = sense > 0 ? run.to : run.from;
    branch.dyad = sense > 0 ? run.to_dyad : run.from_dyad;
    if (branch.dyad < 0 && !turns()) return std::nullopt;
    branch.assembly_ranges.runs = {std::move(run)};
    return branch;
  }

  /// Of a drive that meets no dead point.
  std::optional<CircuitRange> over_turns(double start, const std::vector<double>& sides) {
    set_sides(mechanism_, sides);
    AssemblyRanges assembly_ranges = follow(mechanism_, start, start + kTurn, stop_);
    const auto goes_on = [&] {
      const AssemblyRange& run = assembly_ranges.runs.front();
      return !groups_stand_alike(mechanism_, run, run.from, run, run.to);
    };
    for (int turns = 2; turns <= kMostTurns && !assembly_ranges.runs.empty(); ++turns) {
      const bool is_whole = assembly_ranges.points.empty() && !goes_on();
      if (is_whole || (turns > 2 && !has_groups(mechanism_))) break;
      assembly_ranges = follow(mechanism_, start, start + turns * kTurn, stop_);
    }
    const auto range = output_range(mechanism_, assembly_ranges, travel_);
    if (!range) return std::nullopt;
    return result(range->stroke());
  }

  CircuitRange result(double stroke) const {
    const bool full = !travel_.slides && stroke >= kTurn * (1 - 1e-9);
    return {full ? kTurn : stroke, full};
  }

  /// From the dead point `start`, upwards first, until that comes again.
  std::optional<CircuitRange> round(const Branch& first) {
    const double start = first.end;
    const std::vector<double> first_sides = sides_at(first.run(), start);
    std::vector<double> sides = first_sides;
    double place = start, value = 0, least = 0, greatest = 0;
    for (int i = 0, sense = 1; i < kMostBranches; ++i, sense = -sense) {
      const auto next = branch(place, sense, sides);
      if (!next || next->dyad < 0) return std::nullopt;
      const auto range = output_range(mechanism_, next->assembly_ranges, travel_);
      if (!range) return std::nullopt;
      const OutputValue& entry = sense > 0 ? range->first : range->last;
      const OutputValue& exit = sense > 0 ? range->last : range->first;
      least = std::min(least, value + (range->least.value - entry.value));
      greatest = std::max(greatest, value + (range->greatest.value - entry.value));
      value += exit.value - entry.value;
      sides = sides_at(next->run(), next->end);
      const auto dead = static_cast<std::size_t>(next->dyad);
      const bool is_group = std::holds_alternative<Group>(mechanism_.dyads[dead]);
      if (!is_group) sides[dead] = -sides[dead];
      const bool is_alike =
          groups_stand_alike(mechanism_, next->run(), next->end, first.run(), start);
      draw_groups(mechanism_, next->run(), next->end);
      if (is_group && !draw_beyond(mechanism_, next->run(), next->dyad, sense < 0)) {
        return std::nullopt;
      }
      place = next->end;
      const bool is_back = sense < 0 && sides == first_sides && is_alike;
      const double apart = turns() ? std::remainder(place - start, kTurn) : place - start;
      if (is_back && std::abs(apart) <= kSameRange * scale_) {
        const bool came_round = !travel_.slides && std::abs(value) > 1;
        return came_round ? CircuitRange{kTurn, true} : result(greatest - least);
      }
    }
    return std::nullopt;
  }

  Mechanism<double> mechanism_;
  const Travel& travel_;
  const std::function<bool()>& stop_;
  double reach_ = 0;
  double scale_ = 1;
};

}  // namespace

std::optional<CircuitRange> circuit_range(const Mechanism<double>& mechanism,
                                          const AssemblyRange& run, const Travel& travel,
                                          const std::function<bool()>& stop) {
  double drive = run.from + (run.to - run.from) / 2;
  const auto is_change = [&](const Change& change) {
    return std::abs(change.drive - drive) <= kSameRange * (run.to - run.from);
  };
  if (std::ranges::any_of(run.changes, is_change)) drive = run.from + (run.to - run.from) * 0.382;
  Mechanism<double> drawn = mechanism;
  draw_groups(drawn, run, drive);
  return Circuit(std::move(drawn), travel, stop).from(drive, sides_at(run, drive));
}

}  // namespace cognate
