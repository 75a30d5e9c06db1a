/// The dyads of the pivots that a file gives, for two or three poses.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/dyad_options.hpp"
#include "synthesis/exact/motion/seen_from_body.hpp"
#include "synthesis/exact/motion/three_poses.hpp"
#include "synthesis/exact/motion/two_poses.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidanceStatus;
using synthesis::GuidingDyad;
using synthesis::Line;
using synthesis::Pose;

std::string at_point(const char* what, const Vec2d& at) {
  return fmt::format("{} [{:.6g}, {:.6g}]", what, at.x, at.y);
}

/// Steps along a whole line.
constexpr double kLineStep = 0.05;

/// The dyads whose second pivot lies anywhere on a line: an rr dyad for each parameter.
DyadChoices on_line(const MotionProblem& problem, const std::function<GuidingDyad(double)>& dyad) {
  DyadChoices options;
  if (!allows(problem, DyadKind::rr)) return options;
  options.dyad_at = [dyad](const DyadPlace& at) -> std::optional<GuidingDyad> {
    if (!(std::abs(at[0]) < 0.999)) return std::nullopt;
    return dyad(at[0]);
  };
  for (int i = -18; i <= 18; ++i) {
    const double parameter = kLineStep * i;
    options.choices.push_back({dyad(parameter), {parameter}, {kLineStep}});
  }
  return options;
}

/// The first pole-free scale of the problem's lengths: the extent, or where the body's origin
/// stands still that of the pivot.
double scale_of(const std::vector<Pose>& poses, double fallback) {
  const double extent = synthesis::extent(poses);
  return extent > 0 ? extent : fallback;
}

/// A pivot at the pole of two poses: links to any second pivot will do. `dyad` makes the one to a
/// pivot so far away; of the length given, or any length about `scale`.
DyadChoices dyad_at_pole(const MotionProblem& problem,
                         const std::function<GuidingDyad(Vec2d)>& dyad,
                         const std::optional<double>& length, double scale) {
  constexpr int kSide = 10, kAngles = 36;
  DyadChoices options;
  if (!allows(problem, DyadKind::rr)) return options;
  options.dyad_at = [=](const DyadPlace& at) -> std::optional<GuidingDyad> {
    return dyad(length ? *length * Vec2d{std::cos(at[0]), std::sin(at[0])}
                       : scale * Vec2d{at[0], at[1]});
  };
  if (!length) {
    add_grid(kSide, {}, {}, options);
    return options;
  }
  constexpr double kStep = kTurn / kAngles;
  for (int i = 0; i < kAngles; ++i) {
    const DyadPlace at{i * kStep};
    options.choices.push_back({*options.dyad_at(at), at, {kStep}});
  }
  return options;
}

/// The distance of the farthest other pivot given from `pivot`; 1 where all are the same.
double reach_of_pivots(const std::vector<Vec2d>& pivots, const Vec2d& pivot) {
  double reach = 0;
  for (const Vec2d& other : pivots) reach = std::max(reach, norm(other - pivot));
  return reach > 0 ? reach : 1;
}

Line pivot_line(const std::array<double, 3>& line) {
  const auto& [a, b, c] = line;
  const double size = std::hypot(a, b);
  const Vec2d normal{a / size, b / size};
  return {(c / size) * normal, perp(normal)};
}

/// rr dyads of a moving pivot whose fixed pivot lies on `line`.
DyadChoices fixed_pivots_along(const MotionProblem& problem, const Vec2d& pivot, const Line& line) {
  const double scale = scale_of(problem.poses, norm(pivot));
  return on_line(problem, [=, all = problem.poses](double parameter) {
    return synthesis::rr_dyad(all, pivot, line.point + (scale * along(parameter)) * line.direction);
  });
}

DyadChoices two_poses_by_pole(const MotionProblem& problem, const Vec2d& pivot,
                              const std::optional<double>& length) {
  const Vec2d pole = synthesis::to_frame(problem.poses[0], pivot);
  const double scale = scale_of(problem.poses, reach_of_pivots(problem.moving_pivots, pivot));
  DyadChoices options =
      problem.fixed_pivot_line
          ? fixed_pivots_along(problem, pivot, pivot_line(*problem.fixed_pivot_line))
          : dyad_at_pole(
                problem,
                [=, all = problem.poses](const Vec2d& way) {
                  return synthesis::rr_dyad(all, pivot, pole + way);
                },
                length, scale);
  options.notes.push_back(
      at_point("Moving pivot", pivot) +
      ": it is at the pole of the two poses and does not move between them; any "
      "fixed pivot will do.");
  return options;
}

DyadChoices two_poses_by_moving_pivot(const MotionProblem& problem, const Vec2d& pivot,
                                      const std::optional<double>& length) {
  const auto poses = fixed_size<2>(problem.poses);
  const std::string what = at_point("Moving pivot", pivot);
  const auto line = synthesis::fixed_pivots_of(poses, pivot);
  if (!line) return two_poses_by_pole(problem, pivot, length);
  if (problem.fixed_pivot_line) {
    const auto found =
        synthesis::dyads_with_fixed_pivot_on(poses, pivot, pivot_line(*problem.fixed_pivot_line));
    if (found.status != GuidanceStatus::same_line) return listed(problem, found, what);
  } else if (length) {
    return listed(problem, synthesis::dyads_of_length(poses, pivot, *length), what);
  }
  DyadChoices options = fixed_pivots_along(problem, pivot, *line);
  if (!problem.fixed_pivot_line) add_dyads(problem, synthesis::slider_of(poses, pivot), options);
  return options;
}

DyadChoices two_poses_by_fixed_pivot(const MotionProblem& problem, const Vec2d& pivot,
                                     const std::optional<double>& length) {
  const auto poses = fixed_size<2>(problem.poses);
  const std::string what = at_point("Fixed pivot", pivot);
  const auto seen = synthesis::seen_from_body(poses, pivot);
  const auto line = synthesis::moving_pivots_of(poses, pivot);
  if (!line) {
    const double scale = scale_of(problem.poses, reach_of_pivots(problem.fixed_pivots, pivot));
    DyadChoices options = dyad_at_pole(
        problem,
        [=, all = problem.poses](const Vec2d& way) {
          return synthesis::rr_dyad(all, synthesis::to_body(all[0], pivot + way), pivot);
        },
        length, scale);
    options.notes.push_back(what +
                            ": it is the pole of the two poses, about which the body may turn as a "
                            "whole; any moving pivot will do.");
    return options;
  }
  if (length) {
    const auto inverted = synthesis::dyads_of_length(seen, Vec2d{}, *length);
    return listed(problem, synthesis::seen_from_frame(inverted, poses, pivot), what);
  }
  const double scale = scale_of(problem.poses, norm(line->point));
  const auto all = problem.poses;
  DyadChoices options = on_line(problem, [=](double parameter) {
    return synthesis::rr_dyad(all, line->point + (scale * along(parameter)) * line->direction,
                              pivot);
  });
  add_dyads(problem, synthesis::seen_from_frame(synthesis::slider_of(seen, Vec2d{}), poses, pivot),
            options);
  return options;
}

DyadChoices three_poses_by_pivot(const MotionProblem& problem, const Vec2d& pivot, bool moving) {
  const auto poses = fixed_size<3>(problem.poses);
  return moving ? listed(problem, synthesis::dyads_with_moving_pivot(poses, pivot),
                         at_point("Moving pivot", pivot))
                : listed(problem, synthesis::dyads_with_fixed_pivot(poses, pivot),
                         at_point("Fixed pivot", pivot));
}

}  // namespace

DyadChoices dyad_of_pivot(const MotionProblem& problem, const Vec2d& pivot, bool moving,
                          const std::optional<double>& length) {
  if (problem.poses.size() == 3) return three_poses_by_pivot(problem, pivot, moving);
  return moving ? two_poses_by_moving_pivot(problem, pivot, length)
                : two_poses_by_fixed_pivot(problem, pivot, length);
}

}  // namespace cognate::problems
