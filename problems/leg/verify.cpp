#include "problems/leg/verify.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/chain/verify.hpp"
#include "problems/linkage/gait_quantities.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

/// Relative: the stride is a size that any leg can be scaled to.
constexpr double kStrideTolerance = 3e-5;
/// Crank angles reported of a stance, for which its mean square counts in the sum of squares.
constexpr int kEnds = 2;

void check_one(const char* name, double value, const std::optional<double>& limit, double sign,
               double tolerance, Design& design) {
  if (!limit) return;
  const bool satisfied = sign * (value - *limit) >= -tolerance;
  design.constraints.push_back({name, value, *limit, satisfied});
}

void check_gait(const LegProblem& problem, const Gait& gait, Design& design) {
  const LegTarget& target = problem.target;
  const double length = kCheckTolerance * std::max(gait.stride, gait.height);
  const bool is_long = std::abs(gait.stride - target.stride) <= kStrideTolerance * target.stride;
  design.constraints.push_back(
      {"stride", gait.stride, Range{target.stride, target.stride}, is_long});
  check_one("duty_min", gait.duty, target.duty, 1, kCheckTolerance, design);
  check_one("height_min", gait.height, target.height_min, 1, length, design);
  check_one("height_max", gait.height, target.height_max, -1, length, design);
  check_one("flatness_max", gait.flatness(), target.flatness_max, -1, kCheckTolerance, design);
  const LegConstraints& limits = problem.constraints;
  check_one("foot_speed_min", gait.speed_min, limits.foot_speed_min, 1, kCheckTolerance, design);
  check_one("foot_speed_max", gait.speed_max, limits.foot_speed_max, -1, kCheckTolerance, design);
}

void measure_gait(const LegProblem& problem, const Topology& topology,
                  const NamedMechanism& mechanism, double duty, Design& design) {
  const auto found = foot_gait(topology, mechanism, duty);
  if (!found) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    design.error = {kNone, kNone, kNone};
    return;
  }
  design.error = {kEnds * found->square, std::sqrt(found->square), 0.5 * found->band};
  design.crank_angles = {found->from, in_one_turn(found->to)};
  std::ranges::move(gait_quantities(*found), std::back_inserter(design.metrics.quantities));
  check_gait(problem, *found, design);
}

}  // namespace

std::optional<Gait> foot_gait(const Topology& topology, const NamedMechanism& mechanism,
                              double duty) {
  const auto& name = topology.lines[static_cast<std::size_t>(topology.trace)].name;
  const auto foot = std::ranges::find(mechanism.points, name, &NamedPoint::name);
  return gait(mechanism.mechanism, foot->at, duty);
}

Design verified(const LegProblem& problem, const Topology& topology, NamedMechanism mechanism,
                double duty) {
  Design design;
  design.metrics.quantities.push_back({"topology", topology.name});
  measure_gait(problem, topology, mechanism, duty, design);
  const AssemblyRanges motion = follow(mechanism.mechanism, 0, kTurn);
  measure_transmission(topology, mechanism, motion, design.metrics);
  check_transmission(problem.constraints.transmission_angle, design);
  check_circuit(topology, mechanism, motion, design);
  design.mechanism = std::move(mechanism);
  return design;
}

}  // namespace cognate::problems
