#include "problems/guidance/loci.hpp"

#include <fmt/core.h>

#include <optional>
#include <span>
#include <utility>

#include "synthesis/exact/motion/burmester_curves.hpp"
#include "synthesis/exact/motion/three_poses.hpp"
#include "synthesis/exact/motion/two_poses.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidanceStatus;
using synthesis::Pose;

/// Neighbours on a drawn curve are at most so many extents apart; beyond it the curve passes
/// through infinity or out of what is drawn.
constexpr double kSpacing = 0.02;
constexpr double kReach = 8;
constexpr double kBreak = 4;

void add_two_poses(const MotionProblem& problem, Result& result) {
  const std::span<const Pose, 2> poses(problem.poses.data(), 2);
  if (const auto pole = synthesis::pole(synthesis::displacement(poses[0], poses[1]))) {
    result.loci.push_back({"pole", {{*pole}}});
  }
  const double half = kReach / 4 * synthesis::extent(poses);
  for (const Vec2d& pivot : problem.moving_pivots) {
    const auto line = synthesis::fixed_pivots_of(poses, pivot);
    if (!line || half == 0) continue;
    result.loci.push_back(
        {"fixed pivots of a moving pivot",
         {{line->point - half * line->direction, line->point + half * line->direction}}});
  }
}

void add_three_poses(const MotionProblem& problem, Result& result) {
  const auto poles = synthesis::pole_triangle(std::span<const Pose, 3>(problem.poses.data(), 3));
  if (!poles.p12 || !poles.p23 || !poles.p31) return;
  result.loci.push_back({"pole triangle", {{*poles.p12, *poles.p23, *poles.p31, *poles.p12}}});
}

using Points = std::vector<synthesis::BurmesterCurves::Point>;

/// What can be drawn of a branch: both pivots within a few reaches of the poses.
Points drawable(const synthesis::BurmesterCurves& curves, int branch, std::span<const Pose> poses) {
  const double most = 4 * kReach * synthesis::extent(poses);
  Points points;
  for (const auto& point : curves.trace(branch, kSpacing, kReach)) {
    const auto& dyad = point.dyad;
    const bool near = norm(dyad.fixed - poses[0].at) <= most &&
                      norm(dyad.moving - poses[0].at) <= most;  // false for what is no number
    if (dyad.kind == DyadKind::rr && near) points.push_back(point);
  }
  return points;
}

/// The curve of one pivot, broken where it passes through infinity.
std::vector<std::vector<Vec2d>> polylines(const Points& points, double extent,
                                          Vec2d synthesis::GuidingDyad::*pivot) {
  std::vector<std::vector<Vec2d>> lines;
  std::optional<Vec2d> last;
  for (const auto& point : points) {
    const Vec2d at = point.dyad.*pivot;
    if (!last || norm(at - *last) > kBreak * extent) lines.emplace_back();
    lines.back().push_back(at);
    last = at;
  }
  std::erase_if(lines, [](const std::vector<Vec2d>& line) { return line.size() < 2; });
  return lines;
}

Family family(int branch, const Points& points) {
  Family made{fmt::format("Burmester curve, branch {}", branch + 1),
              {{"parameter", {}},
               {"fixed_x", {}},
               {"fixed_y", {}},
               {"moving_x", {}},
               {"moving_y", {}},
               {"length", {}}}};
  for (const auto& point : points) {
    const auto& dyad = point.dyad;
    const double row[] = {point.parameter, dyad.fixed.x,  dyad.fixed.y,
                          dyad.moving.x,   dyad.moving.y, dyad.length};
    for (std::size_t k = 0; k < made.columns.size(); ++k) made.columns[k].values.push_back(row[k]);
  }
  return made;
}

void add_four_poses(const MotionProblem& problem, Result& result) {
  const std::span<const Pose, 4> poses(problem.poses.data(), 4);
  const synthesis::BurmesterCurves curves(poses);
  if (curves.status() != GuidanceStatus::family) return;
  Locus centre{"centre-point curve", {}}, circle{"circle-point curve", {}};
  const double extent = synthesis::extent(poses);
  for (int branch = 0; branch < curves.branch_count(); ++branch) {
    const Points points = drawable(curves, branch, poses);
    if (points.empty()) continue;
    for (auto& line : polylines(points, extent, &synthesis::GuidingDyad::fixed)) {
      centre.branches.push_back(std::move(line));
    }
    for (auto& line : polylines(points, extent, &synthesis::GuidingDyad::moving)) {
      circle.branches.push_back(std::move(line));
    }
    result.families.push_back(family(branch, points));
  }
  result.loci.push_back(std::move(centre));
  result.loci.push_back(std::move(circle));
}

}  // namespace

void add_motion_loci(const MotionProblem& problem, Result& result) {
  switch (problem.poses.size()) {
    case 2:
      return add_two_poses(problem, result);
    case 3:
      return add_three_poses(problem, result);
    case 4:
      return add_four_poses(problem, result);
    default:
      return;
  }
}

}  // namespace cognate::problems
