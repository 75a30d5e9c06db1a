#include "problems/evaluation/mechanism_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/motion_summary.hpp"
#include "problems/evaluation/type_quantities.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr double kSame = 1e-7;  // of the drive's scale, as for four-bars

using States = std::span<const DriveState>;

bool slides(const Mechanism<double>& mechanism) {
  return driven_by_length(mechanism.drive);
}

bool has_sides(const Dyad<double>& dyad) {
  return !std::holds_alternative<Prp<double>>(dyad) && !std::holds_alternative<Rpp<double>>(dyad);
}

/// Twice the greatest distance of a body's origin from the first one that moves: beyond so much of
/// a driving slider's way nothing new closes or opens.
double reach(const Mechanism<double>& mechanism, States states) {
  MechanismMotion<0> motion(mechanism);
  double size = 0;
  for (const DriveState& state : states) {
    if (!motion.move_to(state.drive)) continue;
    const Vec2d first = motion.bodies()[1].origin[0];
    for (const auto& body : motion.bodies().subspan(1)) {
      size = std::max(size, norm(body.origin[0] - first));
    }
  }
  return 2 * size;
}

/// The whole motion: a turn of what turns, cut where the mechanism cannot be assembled if there is
/// such a place; a driving slider's way between the states and its reach beyond.
AssemblyRanges whole_assembly_ranges(const Mechanism<double>& mechanism, States states) {
  if (slides(mechanism)) {
    const auto [least, greatest] = std::ranges::minmax(states, {}, &DriveState::drive);
    const double margin = reach(mechanism, states) + (greatest.drive - least.drive);
    return follow(mechanism, least.drive - margin, greatest.drive + margin);
  }
  const auto ranges = ranges_over_a_turn(mechanism);
  double start = states.empty() ? 0 : states.front().drive;
  if (!ranges.empty() && ranges.front().to - ranges.front().from < kTurn) {
    const double before = ranges.back().to - kTurn;  // where the gap before the first range begins
    start = before + (ranges.front().from - before) / 2;
  }
  return follow(mechanism, start, start + kTurn);
}

bool is_full_turn(const Mechanism<double>& mechanism, const AssemblyRanges& assembly_ranges) {
  return !slides(mechanism) && assembly_ranges.runs.size() == 1 &&
         assembly_ranges.runs[0].to - assembly_ranges.runs[0].from >= kTurn - kSame;
}

/// How states pass through the assembly ranges of a motion.
class Passage {
 public:
  Passage(const Mechanism<double>& mechanism, const AssemblyRanges& assembly_ranges, States states)
      : mechanism_(mechanism),
        assembly_ranges_(assembly_ranges),
        full_(is_full_turn(mechanism, assembly_ranges)) {
    for (const DriveState& state : states) place(state);
  }

  std::vector<Defect> defects(PointOrder order) const {
    std::vector<Defect> found;
    if (circuit_) found.push_back(Defect::circuit);
    if (branch_) found.push_back(Defect::branch);
    if (!circuit_ && order == PointOrder::cyclic && !in_order()) found.push_back(Defect::order);
    return found;
  }

  bool is_full() const { return full_; }
  std::span<const double> drives() const { return drives_; }

 private:
  double tolerance() const { return kSame * assembly_ranges_.scale; }

  /// The run that holds `drive` or ends no farther than the tolerance from it.
  const AssemblyRange* run_near(double drive) const {
    for (const AssemblyRange& run : assembly_ranges_.runs) {
      if (drive >= run.from - tolerance() && drive <= run.to + tolerance()) return &run;
    }
    return nullptr;
  }

  void place(const DriveState& state) {
    double drive = state.drive;
    if (!slides(mechanism_)) {
      drive = assembly_ranges_.start + std::remainder(drive - assembly_ranges_.start - kPi, kTurn) +
              kPi;
    }
    const AssemblyRange* run = run_near(drive);
    if (run == nullptr || (run_ != nullptr && run != run_)) circuit_ = true;
    if (run_ == nullptr) run_ = run;
    if (run == nullptr) return;
    drive = std::clamp(drive, run->from, run->to);
    compare_sides(state, *run, drive);
    drives_.push_back(drive);
  }

  void compare_sides(const DriveState& state, const AssemblyRange& run, double drive) {
    const auto sides = sides_at(run, drive);
    bool other = false;
    const bool at_end = drive - run.from <= tolerance() || run.to - drive <= tolerance();
    for (std::size_t i = 0; i < sides.size() && i < state.sides.size(); ++i) {
      const bool differs = sides[i] * state.sides[i] < 0 && has_sides(mechanism_.dyads[i]);
      if (!differs || (at_end && !full_)) continue;
      const auto dyad = static_cast<int>(i);
      if (full_ || (run.from_dyad != dyad && run.to_dyad != dyad)) circuit_ = true;
      branch_ = true;
      other = true;
    }
    beyond_.push_back(other);
  }

  /// Coordinates along the circuit, and its length; infinite for a range that does not close.
  bool in_order() const {
    if (drives_.size() < 3 || run_ == nullptr) return true;
    if (full_) return is_cyclic(drives_, kTurn);
    const double length = run_->to - run_->from;
    if (!branch_) {
      return std::ranges::is_sorted(drives_) || std::ranges::is_sorted(drives_, std::greater{});
    }
    std::vector<double> round;
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      const double along = drives_[i] - run_->from;
      round.push_back(beyond_[i] ? 2 * length - along : along);
    }
    return is_cyclic(round, 2 * length);
  }

  /// Whether coordinates of period `period` follow one another in one sense, once round at most.
  bool is_cyclic(const std::vector<double>& at, double period) const {
    for (const double sense : {1.0, -1.0}) {
      double way = 0;
      for (std::size_t i = 1; i < at.size(); ++i) {
        const double step = sense * (at[i] - at[i - 1]);
        const double gap = step - period * std::floor(step / period);
        way += period - gap <= tolerance() ? 0 : gap;
      }
      if (way <= period + tolerance()) return true;
    }
    return false;
  }

  const Mechanism<double>& mechanism_;
  const AssemblyRanges& assembly_ranges_;
  bool full_;
  const AssemblyRange* run_ = nullptr;
  bool circuit_ = false;
  bool branch_ = false;
  std::vector<double> drives_;
  std::vector<bool> beyond_;
};

void take_summary(const MotionSummary& summary, Metrics& metrics) {
  if (const auto& angles = summary.transmission) {
    metrics.transmission_min = angles->min;
    metrics.transmission_max = angles->max;
    metrics.transmission_acute_min = angles->acute_min;
  }
  metrics.time_ratio = summary.time_ratio;
  std::ranges::copy(summary.quantities, std::back_inserter(metrics.quantities));
}

void take_type(const NamedMechanism& mechanism, double start, Metrics& metrics) {
  metrics.quantities = type_quantities(mechanism, start);
  metrics.change_point = find_quantity(metrics.quantities, kChangePointKey).value_or(false);
  std::erase_if(metrics.quantities, [](const Quantity& quantity) {
    return quantity.name == kChangePointKey.name || quantity.name == kMobilityKey.name;
  });
}

Metrics four_bar_metrics(const FourBar& linkage, States states, PointOrder order) {
  std::vector<CrankPosition> positions;
  for (const DriveState& state : states) {
    const bool crossed = !state.sides.empty() && state.sides[0] < 0;
    positions.push_back({state.drive, crossed ? Assembly::crossed : Assembly::open});
  }
  return design_metrics(linkage, std::span<const CrankPosition>(positions), {order, false});
}

}  // namespace

Metrics mechanism_metrics(const NamedMechanism& mechanism, States states, PointOrder order) {
  if (mechanism.four_bar()) return four_bar_metrics(*mechanism.four_bar(), states, order);
  const AssemblyRanges whole = whole_assembly_ranges(mechanism.mechanism, states);
  const Passage passage(mechanism.mechanism, whole, states);

  Metrics metrics;
  metrics.transmission_min = metrics.transmission_max = metrics.transmission_acute_min =
      kRightAngle;
  metrics.defects = passage.defects(order);
  AnalysisProblem problem;
  problem.mechanism = mechanism;
  problem.drive.start = whole.start;
  problem.drive.end = whole.end;
  const Deadline never{Run{}};
  take_type(mechanism, whole.start, metrics);
  const bool sound =
      std::ranges::none_of(metrics.defects, [](Defect defect) { return defect != Defect::order; });
  if (passage.is_full() || !sound || passage.drives().empty()) {
    take_summary(summarise(problem, whole, never), metrics);
  } else {
    const auto [least, greatest] = std::ranges::minmax(passage.drives());
    const AssemblyRanges used = follow(mechanism.mechanism, least, greatest);
    take_summary(summarise(problem, used, never), metrics);
  }
  return metrics;
}

}  // namespace cognate::problems
