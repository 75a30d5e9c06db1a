#include "problems/chain/verify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "analysis/mechanism/transmission_extremes.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/chain/crank_motion.hpp"
#include "problems/chain/three_pin/transmission.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/placement.hpp"
#include "problems/linkage/verify.hpp"
#include "synthesis/chain/bodies.hpp"

namespace cognate::problems {
namespace {

constexpr double kNoError = std::numeric_limits<double>::infinity();
constexpr double kSameAngle = 1e-9;  ///< radians: the crank angles of two targets are equal

Attached<double> traced_point(const NamedMechanism& mechanism, const std::string& name) {
  const auto found = std::ranges::find(mechanism.points, name, &NamedPoint::name);
  return found->at;
}

TargetError target_error(const ChainPathProblem& problem, const Topology& topology,
                         const NamedMechanism& mechanism, const std::vector<double>& angles,
                         const CurvePlacement& placement) {
  const auto point =
      traced_point(mechanism, topology.lines[static_cast<std::size_t>(topology.trace)].name);
  CrankMotion motion(mechanism.mechanism);
  TargetError error;
  for (std::size_t j = 0; j < angles.size(); ++j) {
    if (!motion.move_to(angles[j])) return {kNoError, kNoError, kNoError};
    const double distance = norm(placement.point_back(motion.point(point)) - problem.points[j]);
    error.sum_of_squares += distance * distance;
    error.max = std::max(error.max, distance);
  }
  error.rms = std::sqrt(error.sum_of_squares / double(angles.size()));
  return error;
}

/// The part of the crank's turn over which limits hold.
AssemblyRanges limited_motion(const ChainPathProblem& problem, const NamedMechanism& mechanism,
                              const std::vector<double>& angles) {
  if (problem.constraints.over == LimitSpan::turn) return follow(mechanism.mechanism, 0, kTurn);
  const auto [least, greatest] = std::ranges::minmax(angles);
  return follow(mechanism.mechanism, least, greatest);
}

/// Whether the angles go once round at most, in one sense; equal ones are in order.
bool in_order(const std::vector<double>& angles) {
  double least = kNoError, greatest = -kNoError;
  for (std::size_t j = 1; j < angles.size(); ++j) {
    least = std::min(least, angles[j] - angles[j - 1]);
    greatest = std::max(greatest, angles[j] - angles[j - 1]);
  }
  const double whole = std::abs(angles.back() - angles.front());
  return (least >= -kSameAngle || greatest <= kSameAngle) && whole <= kTurn + kSameAngle;
}

void check_defects(const ChainPathProblem& problem, const Topology& topology,
                   const NamedMechanism& mechanism, const AssemblyRanges& motion, bool ordered,
                   Design& design) {
  check_circuit(topology, mechanism, motion, design);
  if (!ordered) design.metrics.defects.push_back(Defect::order);
  if (problem.crank_angles.empty()) {
    design.constraints.push_back(
        {"no_order_defect", std::string(ordered ? "none" : "order"), std::string("none"), ordered});
  }
}

/// The least of each of three pins, which is acute.
void add_pin_transmission(const Topology& topology, int last, const std::array<double, 3>& least,
                          Metrics& metrics) {
  for (std::size_t pin = 0; pin < least.size(); ++pin) {
    const auto line = static_cast<std::size_t>(last) - 2 + pin;
    metrics.quantities.push_back(
        {"transmission_" + topology.lines[line].name + "_min_deg", degrees(least[pin])});
  }
}

void check_error_limit(const ChainPathProblem& problem, Design& design) {
  const auto& limit = problem.constraints.rms_error_max;
  if (limit) check_error(ErrorLimit{ErrorMeasure::rms_length, *limit}, design.error.rms, design);
}

}  // namespace

void measure_transmission(const Topology& topology, const NamedMechanism& mechanism,
                          const AssemblyRanges& motion, Metrics& metrics) {
  double all_least = kNoError, all_greatest = -kNoError;
  const auto moving = synthesis::joints(chain_of(topology));
  int dyad = 0;
  for (std::size_t k = 0; k < topology.lines.size(); ++k) {
    if (topology.lines[k].line.type == synthesis::LineType::third_pin) {
      const auto least = least_pin_transmission(mechanism.mechanism, motion, dyad);
      dyad += 2;
      all_least = std::min(all_least, std::ranges::min(least));
      all_greatest = std::max(all_greatest, kPi - std::ranges::min(least));
      add_pin_transmission(topology, static_cast<int>(k), least, metrics);
      continue;
    }
    if (!is_dyad(topology.lines[k].line.type)) continue;
    const int own = dyad++;
    if (std::ranges::count(moving, static_cast<int>(k)) == 0) continue;
    const auto extremes = transmission_extremes(mechanism.mechanism, motion, own);
    if (!extremes) continue;
    const double least = extremes->least.angle, greatest = extremes->greatest.angle;
    all_least = std::min(all_least, least);
    all_greatest = std::max(all_greatest, greatest);
    metrics.quantities.push_back({"transmission_" + topology.lines[k].name + "_min_deg",
                                  degrees(std::min(least, kPi - greatest))});
  }
  metrics.transmission_min = all_least;
  metrics.transmission_max = all_greatest;
  metrics.transmission_acute_min = std::min(all_least, kPi - all_greatest);
}

void check_transmission(const Range& limit, Design& design) {
  if (limit.min <= 0 && limit.max >= kPi) return;
  const Metrics& metrics = design.metrics;
  const double below = limit.min - metrics.transmission_min,
               above = metrics.transmission_max - limit.max;
  const double value = below > above ? metrics.transmission_min : metrics.transmission_max;
  design.constraints.push_back({"transmission_angle_deg", degrees(value),
                                Range{degrees(limit.min), degrees(limit.max)},
                                std::max(below, above) <= kCheckTolerance});
}

void check_circuit(const Topology& topology, const NamedMechanism& mechanism,
                   const AssemblyRanges& motion, Design& design) {
  const bool returns =
      !has_three_pin_link(topology) || returns_after_turn(mechanism.mechanism, motion);
  const bool whole = motion.runs.size() == 1 && motion.points.empty() && returns;
  if (!whole) design.metrics.defects.push_back(Defect::circuit);
  design.constraints.push_back(
      {"no_circuit_defect", std::string(whole ? "none" : "circuit"), std::string("none"), whole});
}

Design verified(const ChainPathProblem& problem, const Topology& topology, NamedMechanism mechanism,
                const std::vector<double>& angles, const std::optional<CurvePlacement>& placement) {
  Design design;
  const AssemblyRanges motion = limited_motion(problem, mechanism, angles);
  design.error =
      target_error(problem, topology, mechanism, angles, placement.value_or(CurvePlacement{}));
  design.placement = placement;
  design.metrics.quantities.push_back({"topology", topology.name});
  if (placement) {
    std::ranges::move(quantities(*placement), std::back_inserter(design.metrics.quantities));
  }
  measure_transmission(topology, mechanism, motion, design.metrics);
  check_transmission(problem.constraints.transmission_angle, design);
  const bool ordered = !problem.crank_angles.empty() || in_order(angles);
  check_defects(problem, topology, mechanism, motion, ordered, design);
  check_error_limit(problem, design);
  for (const double angle : angles) design.crank_angles.push_back(in_one_turn(angle));
  design.mechanism = std::move(mechanism);
  return design;
}

}  // namespace cognate::problems
