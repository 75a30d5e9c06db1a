/// @file The smallest cam that keeps given limits of the pressure angle, exactly.
#pragma once

#include <optional>
#include <vector>

#include "analysis/cam/follower.hpp"
#include "analysis/cam/turn_extremes.hpp"

namespace cognate::synthesis {

/// Limits of the pressure angle in rad, each in (0, π/2).
struct PressureLimits {
  std::optional<double> whole;  ///< of either sign at every position
  std::optional<double> rise;   ///< of either sign over the rises
  std::optional<double> fall;   ///< of either sign over the returns
  /// Over the rises, only on the side to which the cam pushes in them; over the returns, only on
  /// the other.
  std::optional<double> rise_working{}, fall_working{};

  /// Whether anything is limited.
  bool any() const { return whole || rise || fall || rise_working || fall_working; }
};

/// Which of the limits.
enum class PressureLimit { whole, rise, fall, rise_working, fall_working };

/// A position at which one of the limits binds.
struct BindingLimit {
  double angle = 0;  ///< of the cam, rad
  PressureLimit limit = PressureLimit::whole;
};

/// The cam, and why none is smaller.
struct SmallestCam {
  cam::CamDimensions<double> dimensions;
  /// The one or two positions that force the base radius: no cam that keeps the limit in them is
  /// smaller. Empty where it is not the pressure angle that limits the size.
  std::vector<BindingLimit> binding;
  /// Whether they do so only together with a bound (the offset's, or that of the follower's place).
  bool bound_binds = false;
  int rounds = 0;  ///< of exchange
};

/// The least base radius, with the offset free within `offset_least` and `offset_greatest` (which
/// may be infinite, or equal: a given offset). |s′ − e| ≤ tan[α] (s + s₀) at a cam angle is two
/// half planes in (e, s₀), and the base radius the distance of that point from the origin. Nothing
/// where no offset within those bounds has a finite answer.
std::optional<SmallestCam> smallest_translating(const cam::MotionProgramme& programme,
                                                const PressureLimits& limits, double offset_least,
                                                double offset_greatest);

/// The least base radius for an oscillating roller follower with an arm of length `arm`, the centre
/// distance free. Seen from the follower, with the origin in its pivot and the first axis along the
/// arm at displacement 0, the cam's centre is the point X = a (cos ψ₀, sin ψ₀), a limit of the
/// pressure angle is again a half plane of X at every cam angle,
///
///   tan[α] (sin φ, cos φ)·X ± σ (cos φ, −sin φ)·X ≥ ± l (φ′ + σ),
///
/// and the base radius the distance of X from (l, 0). Their normals turn with φ: the ones that bind
/// are found by exchange, each round adding the most violated position of the exact extremes.
std::optional<SmallestCam> smallest_oscillating(const cam::MotionProgramme& programme,
                                                const PressureLimits& limits, cam::ArmSide side,
                                                double arm);

}  // namespace cognate::synthesis
