/// @file What every quick-return mechanism has in common: the angle by which its strokes differ.
///
/// While the output goes from one limit to the other the crank turns by π + θ, and by π − θ on the
/// way back. The time ratio K = (π + θ)/(π − θ) ≥ 1 gives θ = π (K − 1)/(K + 1) in [0, π).
#pragma once

#include <limits>

namespace cognate::synthesis {

/// An interval of a length; without limits where nothing is said.
struct LengthInterval {
  double min = 0;
  double max = std::numeric_limits<double>::infinity();
};

/// θ and the functions of θ/2, each to full relative accuracy for every K from 1 to 1e100: near
/// K = 1 the sine, for great K the cosine is small.
struct ReturnAngle {
  double angle = 0;        ///< θ
  double half_sine = 0;    ///< sin(θ/2)
  double half_cosine = 1;  ///< cos(θ/2)

  /// tan(θ/2), sin θ and cos θ.
  double half_tangent() const { return half_sine / half_cosine; }
  double sine() const { return 2 * half_sine * half_cosine; }
  double cosine() const { return (half_cosine - half_sine) * (half_cosine + half_sine); }
};

/// Of a time ratio K ≥ 1.
ReturnAngle return_angle(double time_ratio);

/// The limits of the stroke of a quick return stand at C₁ and C₂, a distance 2h apart; the crank
/// pivot sees them under θ from one of two circular arcs, mirror images in C₁C₂. Which one a pivot
/// stands on. (The rocker's pivot, where there is one, is D.)
enum class PivotArc {
  near,  ///< on D's side of C₁C₂; below the slide line
  far    ///< beyond C₁C₂ from D; above the slide line
};

/// −1 for `near`, +1 for `far`.
constexpr double sign(PivotArc arc) {
  return arc == PivotArc::near ? -1.0 : 1.0;
}

}  // namespace cognate::synthesis
