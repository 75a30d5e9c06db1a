#include "problems/guidance/scale.hpp"

#include <cmath>

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;

/// Counted from the first place, so that places which are all one have exactly that mean.
Vec2d mean_place(std::span<const Pose> poses) {
  const Vec2d first = poses.front().at;
  Vec2d mean{};
  for (const Pose& pose : poses) mean = mean + (1.0 / double(poses.size())) * (pose.at - first);
  return first + mean;
}

double mean_way(std::span<const Pose> poses) {
  const Vec2d mean = mean_place(poses);
  double largest = 0;  // taken out first, so that squares neither overflow nor vanish
  for (const Pose& pose : poses) largest = std::max(largest, norm(pose.at - mean));
  if (!(largest > 0)) return 0;
  double squares = 0;
  for (const Pose& pose : poses) squares += squared_norm((1 / largest) * (pose.at - mean));
  return largest * std::sqrt(squares / double(poses.size()));
}

}  // namespace

std::optional<Vec2d> given_pivot(const MotionProblem& problem, const std::vector<Vec2d>& pivots,
                                 DyadRole role) {
  const std::size_t number = (role == DyadRole::first) == problem.first_is_driven ? 0 : 1;
  return number < pivots.size() ? std::optional(pivots[number]) : std::nullopt;
}

double natural_angle_weight(std::span<const Pose> poses) {
  const double way = mean_way(poses);
  return way > 0 ? way : 1;
}

MotionScale::MotionScale(const MotionProblem& problem) : problem_(problem) {
  const double way = mean_way(problem.poses);
  similarity_ = {mean_place(problem.poses), way > 0 ? way : problem.angle_weight};
}

MotionProblem MotionScale::into(MotionProblem problem) const {
  for (Pose& pose : problem.poses) pose.at = similarity_.point(pose.at);
  for (Vec2d& pivot : problem.fixed_pivots) pivot = similarity_.point(pivot);
  for (Vec2d& pivot : problem.moving_pivots) pivot = (1 / size()) * pivot;
  similarity_.shrink(problem.crank);
  similarity_.shrink(problem.rocker);
  similarity_.move(problem.bounds);
  for (auto& box : problem.moving_bounds) similarity_.shrink(box);
  similarity_.move(problem.constraints);
  problem.angle_weight /= size();
  return problem;
}

GuidingDyad MotionScale::into(const GuidingDyad& dyad) const {
  GuidingDyad moved = dyad;
  moved.in_body = (1 / size()) * dyad.in_body;
  moved.moving = similarity_.point(dyad.moving);
  moved.fixed = similarity_.point(dyad.fixed);
  moved.length = dyad.length / size();
  return moved;
}

DyadPair MotionScale::into(const DyadPair& pair) const {
  return {into(pair.first), into(pair.second)};
}

Pose MotionScale::out_of(const Pose& pose) const {
  return {similarity_.point_back(pose.at), pose.angle};
}

GuidingDyad MotionScale::out_of(const GuidingDyad& dyad) const {
  GuidingDyad moved = dyad;
  moved.in_body = size() * dyad.in_body;
  moved.moving = similarity_.point_back(dyad.moving);
  moved.fixed = similarity_.point_back(dyad.fixed);
  moved.length = size() * dyad.length;
  return moved;
}

DyadPair MotionScale::out_of(const DyadPair& pair) const {
  DyadPair moved{out_of(pair.first), out_of(pair.second)};
  for (const DyadRole role : {DyadRole::first, DyadRole::second}) {
    const bool first = role == DyadRole::first;
    GuidingDyad& dyad = first ? moved.first : moved.second;
    if (dyad.kind != DyadKind::pr) {
      dyad.fixed = given_pivot(problem_, problem_.fixed_pivots, role).value_or(dyad.fixed);
    }
    if (dyad.kind != DyadKind::rp) {
      dyad.in_body = given_pivot(problem_, problem_.moving_pivots, role).value_or(dyad.in_body);
    }
    if (dyad.kind == DyadKind::rr) {
      dyad.length = (first ? problem_.crank : problem_.rocker).value_or(dyad.length);
    }
  }
  return moved;
}

}  // namespace cognate::problems
