/// @file What a file of kind = "motion-generation" says.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "problems/linkage_limits.hpp"
#include "synthesis/exact/motion/dyad.hpp"
#include "synthesis/exact/motion/pose.hpp"

namespace cognate::problems {

/// `kind = "motion-generation"`: a body is to be carried through two to five poses, each the place
/// of its origin and its angle in the fixed frame.
struct MotionProblem {
  std::string title;
  std::vector<synthesis::Pose> poses;
  /// `target.segments`: where two points of the body stand at each pose, as written. The body's
  /// origin is then at the first, its first axis towards the second. Empty for `target.poses`.
  std::vector<std::array<Vec2d, 2>> segments;

  /// None, one or two pivots of each kind; moving ones in the body's axes. With two or three
  /// segments and no pivot given the two points are the moving pivots.
  std::vector<Vec2d> fixed_pivots, moving_pivots;
  std::optional<std::array<double, 3>> fixed_pivot_line;  ///< a x + b y = c
  std::optional<double> crank, rocker;  ///< lengths of the links on the first and second pivot
  /// Which dyads may be used; in the order of DyadKind, all different, at least one.
  std::vector<synthesis::DyadKind> dyads;

  Bounds bounds;  ///< lengths and fixed pivots
  Constraints constraints;
  Solve solve;
  bool designs_given = false;  ///< whether the file limits how many designs are returned
};

}  // namespace cognate::problems
