/// @file What a file of kind = "motion-generation" says.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"
#include "synthesis/exact/motion/dyad.hpp"
#include "synthesis/exact/motion/pose.hpp"

namespace cognate::problems {

/// `target.method`. `exact`: through each of two to five poses. `least_squares`: as near to three
/// or more as can be.
enum class MotionMethod { exact, least_squares };

/// `kind = "motion-generation"`: a body is to be carried through poses, each the place of its
/// origin and its angle in the fixed frame.
struct MotionProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  MotionMethod method = MotionMethod::exact;
  std::vector<synthesis::Pose> poses;
  /// `target.segments`: where two points of the body stand at each pose, as written. The body's
  /// origin is then at the first, its first axis towards the second. Empty for `target.poses`.
  std::vector<std::array<Vec2d, 2>> segments;
  /// Least squares: what an error of one radian counts, as a length. The error of a pose is
  /// |Δp|² + (weight Δθ)².
  double angle_weight = 1;

  /// None, one or two pivots of each kind; moving ones in the body's axes. Exactly, each makes a
  /// dyad, and with two or three segments and no pivot given the two points are the moving pivots.
  /// By least squares the first of each kind belongs to one dyad, the second to the other.
  std::vector<Vec2d> fixed_pivots, moving_pivots;
  bool first_is_driven = true;  ///< least squares: whether the former is the driven dyad
  std::optional<std::array<double, 3>> fixed_pivot_line;  ///< a x + b y = c
  std::optional<double> crank, rocker;  ///< lengths of the links on the first and second pivot
  /// Which dyads may be used; in the order of DyadKind, all different, at least one.
  std::vector<synthesis::DyadKind> dyads;

  Bounds bounds;  ///< lengths and fixed pivots
  /// Least squares: where the moving pivots of the two dyads may lie, in the body's axes.
  std::array<std::optional<Box>, 2> moving_bounds;
  Constraints constraints;
  Solve solve;
  WarningLimits warnings{};
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
  std::optional<Raster> raster{};  ///< least squares, links alone
  bool designs_given = false;      ///< whether the file limits how many designs are returned
};

template <>
struct KindTraits<MotionProblem> {
  static constexpr std::string_view kWord = "motion-generation";
  static MotionProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const MotionProblem& problem);
  static tl::expected<MotionProblem, std::vector<std::string>> checked(
      const MotionProblem& problem);
};

/// Of the two dyads of a mechanism the driven one, or the other.
enum class DyadRole { first = 0, second = 1 };

/// The pivot out of `pivots` (fixed or moving ones of the problem) that is given for a dyad.
std::optional<Vec2d> given_pivot(const MotionProblem& problem, const std::vector<Vec2d>& pivots,
                                 DyadRole role);

/// The weight that counts a radian as the poses' way: the root mean squared distance of the body's
/// origin from its mean place, so that poses moved or enlarged give the same designs moved or
/// enlarged; 1 where the origin stands still.
double natural_angle_weight(std::span<const synthesis::Pose> poses);

struct Result;
struct Run;

/// Designs for `problem`, each checked by the analysis kernel; see linkage/result.hpp. The same
/// problem and seed give the same designs for any number of threads. An invalid problem gives
/// no design, its faults as notes and Status::invalid.
Result solve(const MotionProblem& problem, const Run& run);

template <>
std::span<const Named<MotionMethod>> names<MotionMethod>();
template <>
std::span<const Named<synthesis::DyadKind>> names<synthesis::DyadKind>();

}  // namespace cognate::problems
