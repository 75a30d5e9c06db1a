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

/// Goes through the branches of a circuit.
class Circuit {
 public:
  Circuit(Mechanism<double> mechanism, const Travel& travel, const std::function<bool()>& stop)
      : mechanism_(std::move(mechanism)), travel_(travel), stop_(stop) {}

  std::optional<CircuitRange> from(double drive, const std::vector<double>& sides) {
    const auto back = branch(drive, -1, sides);
    if (!back) return std::nullopt;
    if (back->dyad < 0) return over_turns(drive, sides);
    return round(back->end, sides_at(back->run(), back->end));
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
    // A little before the start, so that the dead point there ends the run, regardless of rounding.
    const double before = start - sense * kBefore * reach_;
    Branch branch{follow(mechanism_, before, start + sense * reach_, stop_)};
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
    if (!assembly_ranges.points.empty())
      assembly_ranges = follow(mechanism_, start, start + 2 * kTurn, stop_);
    const auto range = output_range(mechanism_, assembly_ranges, travel_);
    if (!range) return std::nullopt;
    return result(range->stroke());
  }

  CircuitRange result(double stroke) const {
    const bool full = !travel_.slides && stroke >= kTurn * (1 - 1e-9);
    return {full ? kTurn : stroke, full};
  }

  /// From the dead point `start`, upwards first, until that comes again.
  std::optional<CircuitRange> round(double start, const std::vector<double>& first_sides) {
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
      double& flipped = sides[static_cast<std::size_t>(next->dyad)];
      flipped = -flipped;
      place = next->end;
      const bool is_back = sense < 0 && sides == first_sides;
      if (is_back && std::abs(place - start) <= kSameRange * scale_) {
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
  return Circuit(mechanism, travel, stop).from(drive, sides_at(run, drive));
}

}  // namespace cognate
