#include "problems/guidance/legs.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "problems/guidance/leg_parts.hpp"
#include "synthesis/exact/motion/burmester_curves.hpp"
#include "synthesis/exact/motion/five_poses.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidanceStatus;
using synthesis::GuidingDyad;

/// About so many places of each curve are tried.
constexpr std::size_t kCurvePoints = 90;

void add_curve(const MotionProblem& problem, const synthesis::BurmesterCurves& curves, int branch,
               Leg& leg) {
  if (!allows(problem, DyadKind::rr)) return;
  constexpr double kReach = 10;
  auto points = curves.trace(branch, 0.05, kReach);
  const double most = 2 * kReach * synthesis::extent(problem.poses);
  std::erase_if(points, [&](const auto& point) {  // also what is no number
    return !(norm(point.dyad.fixed - problem.poses[0].at) <= most) ||
           !(norm(point.dyad.moving - problem.poses[0].at) <= most);
  });
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kCurvePoints);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    if (points[i].dyad.kind != DyadKind::rr) continue;
    const double next = points[std::min(i + stride, points.size() - 1)].parameter;
    const double step = std::clamp(std::abs(next - points[i].parameter), 1e-5, 0.01);
    leg.choices.push_back({points[i].dyad, {double(branch), points[i].parameter}, {0, step}});
  }
}

}  // namespace

bool allows(const MotionProblem& problem, DyadKind kind) {
  return std::ranges::count(problem.dyads, kind) > 0;
}

Legs legs_of_few_poses(const MotionProblem& problem) {
  std::vector<Leg> legs;
  const std::array<std::optional<double>, 2> lengths{problem.crank, problem.rocker};
  for (const bool moving : {true, false}) {
    for (const Vec2d& pivot : moving ? problem.moving_pivots : problem.fixed_pivots) {
      legs.push_back(leg_of_pivot(problem, pivot, moving, lengths.at(legs.size())));
    }
  }
  if (legs.empty()) return {free_leg(problem), std::nullopt};
  if (legs.size() == 1) legs.push_back(free_leg(problem));
  return {std::move(legs[0]), std::move(legs[1])};
}

Leg leg_of_four_poses(const MotionProblem& problem) {
  const auto curves = std::make_shared<synthesis::BurmesterCurves>(fixed_size<4>(problem.poses));
  if (curves->status() == GuidanceStatus::translation) return leg_of_translation(problem);
  if (curves->status() != GuidanceStatus::family) {
    return listed(problem, curves->examples(), "The four poses");
  }
  Leg leg;
  leg.dyad_at = [curves](const LegPlace& at) -> std::optional<GuidingDyad> {
    const double parameter = at[1] - std::floor(at[1]);
    const auto found = curves->at(static_cast<int>(at[0]), parameter);
    if (found.count == 0 || found.storage[0].kind != DyadKind::rr) return std::nullopt;
    return found.storage[0];
  };
  for (int branch = 0; branch < curves->branch_count(); ++branch) {
    add_curve(problem, *curves, branch, leg);
  }
  for (const auto& special : {curves->sliders(), curves->blocks()}) {
    for (const GuidingDyad& dyad : special.dyads()) {
      if (allows(problem, dyad.kind)) leg.choices.push_back({dyad});
    }
  }
  return leg;
}

Leg leg_of_five_poses(const MotionProblem& problem) {
  const auto found = synthesis::dyads_of_five_poses(fixed_size<5>(problem.poses));
  if (found.status == GuidanceStatus::translation) return leg_of_translation(problem);
  Leg leg = listed(problem, found, "The five poses");
  leg.is_degenerate = found.status == GuidanceStatus::rotation;
  return leg;
}

}  // namespace cognate::problems
