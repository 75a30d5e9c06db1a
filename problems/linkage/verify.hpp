/// @file What a finished design is and whether it satisfies its problem, computed by the analysis
/// kernel from the linkage alone, in the file's units: no variable, scale or constraint of a solver
/// enters. The closure is the kernel's in both; the tests hold it against the textbook's triangle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/linkage/defects.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// How a design passes through its target positions.
struct MotionKind {
  PointOrder order = PointOrder::cyclic;
  bool timed = false;  ///< crank angles are prescribed: `order` is then ignored
  /// Crank angles from the x axis between which the crank turns, those of the positions among them;
  /// empty: the motion runs between the positions, by the shorter way where it is timed. A linkage
  /// at a change point is judged over its travel, not over the full turn.
  std::optional<CrankRange> travel{};
};

/// Class, transmission angles over the motion used, time ratio and defects of a design at its
/// crank angles (from the x axis), in its own assembly. The motion used is the full turn of a crank
/// that turns fully, else `motion.travel` or without one the range between the target positions;
/// where the crank cannot make it, which for a travel is a circuit defect, all of the crank's
/// range. The other members of Metrics stay empty.
Metrics design_metrics(const FourBar& linkage, std::span<const double> crank_angles,
                       const MotionKind& motion);

/// As above for positions that each name their side, as exact synthesis finds them.
Metrics design_metrics(const FourBar& linkage, std::span<const CrankPosition> positions,
                       const MotionKind& motion);

/// Relative tolerance of every check: of the larger of limit and longest link for lengths and
/// coordinates, of the limit for ratios, of one radian for angles.
inline constexpr double kCheckTolerance = 1e-9;

/// Sums of squares up to this share of the target's squared size (of 1 rad² for functions) are
/// rounding: the target is met.
inline constexpr double kMetExactly = 1e-20;

/// What a length must exceed where its lower bound is 0, relative to the longest link.
inline constexpr double kLeastLinkRatio = 1e-6;

/// Everything the file demands of a linkage, one check for each number it limits, in the order of
/// the file's tables ("full_turn" is what a closed curve demands): "mechanism.crank" (a fixed
/// dimension), "bounds.crank", "bounds.pivot_a.x", "bounds.frame_angle_deg", and of `[constraints]`
/// "class", "transmission_angle_deg" (the extreme with the lesser margin), "link_ratio_max",
/// "pivot_region.pivot_a.x", "no_branch_defect", … Values are in the file's unit, degrees where the
/// key ends in _deg; defects read "none" or their name. A length without bounds is checked against
/// `kLeastLinkRatio` and named only where it fails.
///
/// A class holds as `metrics` has it (`mobility_class`), Grashof's criterion with no allowance
/// beyond rounding: a crank that stops short of a full turn by any amount does not turn.
std::vector<ConstraintCheck> check_constraints(const Constraints& constraints, const Bounds& bounds,
                                               const Given& given, const FourBar& linkage,
                                               const Metrics& metrics);

/// Whether every check is satisfied.
bool all_satisfied(std::span<const ConstraintCheck> checks);

/// The largest violation among the checks: the distance of the value from its bound, relative to
/// the larger of the two; 1 for a class or defect; 0 where all are satisfied.
double violation(std::span<const ConstraintCheck> checks);

/// Distances from `points` to the coupler point at `crank_angles` (from the x axis, as many). All
/// infinite where the linkage does not close at one of them or has no coupler point.
TargetError path_error(const FourBar& linkage, std::span<const Vec2d> points,
                       std::span<const double> crank_angles);

}  // namespace cognate::problems
