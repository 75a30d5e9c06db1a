/// @file Crank-rockers of a given time ratio whose rocker has a given angle at one of its limits.
///
/// In the plane of rocker.hpp the crank pivot A then lies on a ray from the rocker's pivot D: with
/// the rocker's angles β₁ (outer) and β₂ = β₁ + φ (inner) from A→D, on the ray at the angle
/// α = π − φ/2 − β₁ from the bisector of the swing. On it λ = l₄/l₃ solves
///
///     sin θ λ² − 2 cos α sin(θ + s φ/2) λ + sin(θ + s φ) = 0,
///
/// s = ∓1 for the near and the far arc: at most two linkages on each. With the frame given in place
/// of the swing the limit C₁ is known, and the other one is C₂ = A + t u with
///
///     t² − 2 l₄ t cos ψ + l₄² − l₃² = 0,
///
/// ψ the angle of AC₁ turned by θ to either side: t and |AC₁| are l₂ ± l₁.
#pragma once

#include <optional>

#include "synthesis/exact/quick_return/rocker.hpp"

namespace cognate::synthesis {

/// Which of a rocker's limits: crank and coupler extended, or folded.
enum class RockerLimit { outer, inner };

/// The rocker's angle at one of its limits, from the directed line A→D to D→C, in (0, π); as in
/// `LimitPosition`, whose mirror image has the same with the other sign.
struct RockerLimitAngle {
  RockerLimit limit = RockerLimit::outer;
  double angle = 0;
};

/// All crank-rockers of `task` whose rocker has `given` at a limit. The condition is that of A's
/// place for a change of θ and of this angle, both in radians.
RockerSolutions rockers_at_limit(const RockerTask& task, const RockerLimitAngle& given);

/// Strictly between which angles, in radians, an arc has such linkages; empty where it has none.
struct LimitAngleRange {
  double min = 0;
  double max = 0;
};
std::optional<LimitAngleRange> limit_angle_range(const RockerTask& task, PivotArc arc,
                                                 RockerLimit limit);

/// What is desired in place of a swing: K ≥ 1 and the lengths of rocker and frame, positive.
struct RockerFrameTask {
  double time_ratio = 1;
  double rocker = 0;
  double frame = 0;
};

/// All crank-rockers of `task` whose rocker has `given` at a limit, each in the plane of its own
/// swing. The condition is the change of crank and coupler over the coupler with θ and the angle.
RockerSolutions rockers_with_frame_at_limit(const RockerFrameTask& task,
                                            const RockerLimitAngle& given);

}  // namespace cognate::synthesis
