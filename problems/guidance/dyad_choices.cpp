#include "problems/guidance/dyad_choices.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "problems/guidance/dyad_options.hpp"
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
               DyadChoices& options) {
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
    options.choices.push_back({points[i].dyad, {double(branch), points[i].parameter}, {0, step}});
  }
}

}  // namespace

bool allows(const MotionProblem& problem, DyadKind kind) {
  return std::ranges::count(problem.dyads, kind) > 0;
}

DyadPairChoices dyads_of_few_poses(const MotionProblem& problem) {
  std::vector<DyadChoices> options;
  const std::array<std::optional<double>, 2> lengths{problem.crank, problem.rocker};
  for (const bool moving : {true, false}) {
    for (const Vec2d& pivot : moving ? problem.moving_pivots : problem.fixed_pivots) {
      options.push_back(dyad_of_pivot(problem, pivot, moving, lengths.at(options.size())));
    }
  }
  if (options.empty()) return {free_dyad(problem), std::nullopt};
  if (options.size() == 1) options.push_back(free_dyad(problem));
  return {std::move(options[0]), std::move(options[1])};
}

DyadChoices dyad_of_four_poses(const MotionProblem& problem) {
  const auto curves = std::make_shared<synthesis::BurmesterCurves>(fixed_size<4>(problem.poses));
  if (curves->status() == GuidanceStatus::translation) return dyad_of_translation(problem);
  if (curves->status() != GuidanceStatus::family) {
    return listed(problem, curves->examples(), "The four poses");
  }
  DyadChoices options;
  options.dyad_at = [curves](const DyadPlace& at) -> std::optional<GuidingDyad> {
    const double parameter = at[1] - std::floor(at[1]);
    const auto found = curves->at(static_cast<int>(at[0]), parameter);
    if (found.count == 0 || found.storage[0].kind != DyadKind::rr) return std::nullopt;
    return found.storage[0];
  };
  for (int branch = 0; branch < curves->branch_count(); ++branch) {
    add_curve(problem, *curves, branch, options);
  }
  for (const auto& special : {curves->sliders(), curves->blocks()}) {
    for (const GuidingDyad& dyad : special.dyads()) {
      if (allows(problem, dyad.kind)) options.choices.push_back({dyad});
    }
  }
  return options;
}

DyadChoices dyad_of_five_poses(const MotionProblem& problem) {
  const auto found = synthesis::dyads_of_five_poses(fixed_size<5>(problem.poses));
  if (found.status == GuidanceStatus::translation) return dyad_of_translation(problem);
  DyadChoices options = listed(problem, found, "The five poses");
  options.is_degenerate = found.status == GuidanceStatus::rotation;
  return options;
}

}  // namespace cognate::problems
