/// @file Freudenstein's equation: function generators from pairs of crank and rocker angles.
///
/// With crank 1, coupler l, rocker m, frame n and angles from the directed line A→D, the closure
/// e^{iθ₁} + l e^{iθ₂} = n + m e^{iθ₃} without the coupler's angle is (Freudenstein 1955)
///
///     cos θ₁ = P₀ cos θ₃ + P₁ cos(θ₃ − θ₁) + P₂,
///     P₀ = m,  P₁ = −m/n,  P₂ = (m² + n² + 1 − l²)/(2n):
///
/// linear in the three ratios once the angles are known.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "analysis/linkage/four_bar.hpp"

namespace cognate::synthesis {

/// Angles of crank and rocker that belong together, in radians.
struct AnglePair {
  double input = 0;
  double output = 0;
};

/// P₀, P₁, P₂ and how well they are determined.
struct FreudensteinRatios {
  std::array<double, 3> p{};
  double residual = 0;   ///< largest |right side − left side| over the pairs solved for
  double condition = 0;  ///< ‖M‖₁‖M⁻¹‖₁ of the 3 × 3 matrix that was solved
};

/// The ratios that satisfy the equation at three pairs. Empty where the matrix is singular to
/// working precision (condition above 1e14): pairs that coincide, or rows that are parallel.
std::optional<FreudensteinRatios> freudenstein_exact(std::span<const AnglePair, 3> pairs);

/// The ratios with the least Σ wᵢ (right − left)² over three or more pairs; `weights` is empty (all
/// 1) or has one for each. `condition` is of the normal matrix. Empty where that is singular.
std::optional<FreudensteinRatios> freudenstein_fit(std::span<const AnglePair> pairs,
                                                   std::span<const double> weights = {});

/// What the ratios mean as a linkage.
enum class FreudensteinOutcome {
  linkage,            ///< `links` are positive and finite
  imaginary_coupler,  ///< l² ≤ 0: no linkage has these ratios
  no_rocker,          ///< P₀ = 0: the rocker has no length
  infinite_frame,     ///< P₁ = 0: the frame has no end
};

/// The linkage of some ratios. A negative m is a rocker turned by π, a negative n a frame turned by
/// π; lengths are given positive, and the angles of the pairs become the linkage's own, measured
/// from its directed line A→D, by adding the turns.
struct FreudensteinLinkage {
  FreudensteinOutcome outcome = FreudensteinOutcome::linkage;
  Lengths<double> links;       ///< crank 1
  double coupler_squared = 0;  ///< l², of either sign
  double input_turn = 0;       ///< 0 or π
  double output_turn = 0;      ///< 0 or π
};

/// The linkage that has the ratios `p`, or why there is none.
FreudensteinLinkage freudenstein_linkage(const std::array<double, 3>& p);

}  // namespace cognate::synthesis
