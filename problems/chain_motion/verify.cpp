#include "problems/chain_motion/verify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/chain/crank_motion.hpp"
#include "problems/chain/minima_designs.hpp"
#include "problems/chain/places.hpp"
#include "problems/chain/verify.hpp"
#include "problems/guidance/design.hpp"
#include "problems/linkage/error_limit.hpp"

namespace cognate::problems {
namespace {

using synthesis::Pose;

/// A body in its link, whose axes are those of the kernel.
struct BodyInLink {
  int link;
  Pose pose;
};

template <class Motion>
Pose pose_of(const BodyInLink& body, const Motion& motion) {
  const auto& [link, own] = body;
  const Vec2d axis = motion.bodies()[static_cast<std::size_t>(link)].direction;
  return {motion.point({link, own.at}), angle_of(axis * unit_vector(own.angle))};
}

/// `design` has the heading's parameter after those of the topology.
BodyInLink body_in_link(const Topology& topology, const synthesis::ChainDesign& design) {
  const ChainPlaces places(chain_of(topology).lines, design.parameters);
  const auto& [type, first, second] = topology.lines[static_cast<std::size_t>(topology.trace)].line;
  const auto [link, at] = places.place(topology.trace);
  const Vec2d axis = places.axes(first, second).second;
  return {link, {at, angle_of(axis * unit_vector(design.parameters.back()))}};
}

/// How far the body is from its poses: distances and angles.
struct Misses {
  std::vector<double> place, angle;
};

/// Up to the first pose that is not reached.
Misses misses(const NamedMechanism& mechanism, const BodyInLink& body, std::span<const Pose> poses,
              std::span<const double> cranks) {
  CrankMotion motion(mechanism.mechanism);
  Misses all;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    if (!motion.move_to(cranks[j])) break;
    const Pose reached = pose_of(body, motion);
    all.place.push_back(norm(reached.at - poses[j].at));
    all.angle.push_back(std::abs(std::remainder(reached.angle - poses[j].angle, kTurn)));
  }
  return all;
}

void take_errors(const Misses& missed, double weight, Design& design) {
  std::vector<double> together;
  for (std::size_t i = 0; i < missed.place.size(); ++i) {
    together.push_back(std::hypot(missed.place[i], weight * missed.angle[i]));
  }
  design.error = error_of(together);
  const TargetError place = error_of(missed.place), angle = error_of(missed.angle);
  auto& quantities = design.metrics.quantities;
  quantities.push_back(quantity(kAngleErrorKey, angle.max));
  quantities.push_back({"angle_error_rms_deg", degrees(angle.rms)});
  quantities.push_back({"position_error_rms", place.rms});
  quantities.push_back({"position_error_max", place.max});
}

}  // namespace

ChainPathProblem path_of(const ChainMotionProblem& problem) {
  ChainPathProblem path;
  path.mechanism = problem.mechanism;
  path.topologies = problem.topologies;
  for (const Pose& pose : problem.poses) path.points.push_back(pose.at);
  path.closed = problem.closed;
  path.crank_angles = problem.crank_angles;
  path.constraints = problem.constraints;
  path.constraints.rms_error_max.reset();
  path.solve = problem.solve;
  return path;
}

TargetScale scale_of(const ChainMotionProblem& problem) {
  return TargetScale(path_of(problem).points);
}

const std::string& origin_name(const ChainMotionProblem& problem) {
  const Topology& topology = problem.topologies.front();
  return topology.lines[static_cast<std::size_t>(topology.trace)].name;
}

double angle_weight_of(const ChainMotionProblem& problem) {
  return problem.angle_weight.value_or(scale_of(problem).size);
}

Design verified(const ChainMotionProblem& problem, const ChainMinimum& found) {
  const Topology& topology = *found.problem->topology;
  const auto own = scale_of(problem).out_of(found.problem->chain, found.design);
  const std::vector<double> cranks = angles_of_targets(found);
  Design design = verified(path_of(problem), topology, named(topology, own), cranks);
  const BodyInLink body = body_in_link(topology, own);
  const Misses missed = misses(design.mechanism, body, problem.poses, cranks);
  if (missed.place.size() < problem.poses.size()) {
    design.error.sum_of_squares = std::numeric_limits<double>::infinity();
    return design;
  }
  take_errors(missed, angle_weight_of(problem), design);
  design.metrics.quantities.push_back(quantity(kBodyAngleKey, body.pose.angle));
  const auto& limit = problem.constraints.rms_error_max;
  if (limit) check_error(ErrorLimit{ErrorMeasure::rms_length, *limit}, design.error.rms, design);
  return design;
}

}  // namespace cognate::problems
