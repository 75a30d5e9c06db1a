/// @file Four-bars as function generators through three, four or five precision points.
///
/// With crank 1, coupler l, rocker m, frame n, input θ₁ = φ + φ₀ and output θ₃ = ψ + ψ₀ from A→D,
/// the closure without the coupler's angle is (Freudenstein 1955)
///
///     K₁ cos θ₁ + K₂ cos θ₃ + K₃ = cos(θ₁ − θ₃),
///     K₁ = −n/m,  K₂ = n,  K₃ = (m² + n² + 1 − l²)/(2m).
///
/// With X = K₁e^{iφ₀}, Y = K₂e^{iψ₀}, Z = e^{i(φ₀ − ψ₀)} it is linear and homogeneous in X, Y, K₃
/// and Z, and so is each of its derivatives by the input. Two unknowns more than conditions leave a
/// plane of vectors; that the phases of X, Y and Z belong together is a cubic in their ratio, and
/// where one start angle is given, a quadratic. All real solutions come out, without iteration but
/// for the last digits.
#pragma once

#include <span>

#include "analysis/linkage/four_bar.hpp"
#include "synthesis/exact/function/precision_point.hpp"
#include "synthesis/exact/in_place_vector.hpp"

namespace cognate::synthesis {

/// What a solution of the equations is as a linkage.
enum class FourBarOutcome {
  linkage,          ///< `links` are positive and finite
  no_coupler,       ///< the coupler has no length: crank pin and rocker pin are one
  infinite_rocker,  ///< coupler and rocker infinitely long: a guide-bar
  infinite_crank,   ///< crank and coupler infinitely long: a guide-bar driven by its guide
  rigid,            ///< no frame: the output turns with the input as one body
  infinite_frame,   ///< frame and coupler infinitely long: the links' projections stay in step
};

/// One real solution.
struct FourBarFunction {
  FourBarOutcome outcome = FourBarOutcome::linkage;
  /// Crank 1; what is infinite is 0. Of a guide-bar driven by its guide the rocker is 1.
  Lengths<double> links;
  /// For an infinite rocker: the offset of the guide line on which the crank pin stays, from D.
  double guide_offset = 0;
  /// The linkage's own start angles, measured from A→D: those given, or found, less the turns.
  double input_start = 0, output_start = 0;
  /// Whether a link points away from where a given start angle has it: then the linkage's own start
  /// angle is the one given and half a turn.
  bool input_turned = false, output_turned = false;
  /// Largest error of the equations, relative to the sum of the sizes of their terms: the complex
  /// ones before their real part is taken.
  double residual = 0;
  /// ‖J‖₁‖J⁻¹‖₁ of the equations' slopes in K₁, K₂, K₃ and the start angles found, columns scaled.
  double condition = 0;
};

/// All solutions, or word that there are infinitely many.
struct FourBarFunctions {
  bool dependent = false;  ///< the conditions are dependent to within rounding
  InPlaceVector<FourBarFunction, 3> solutions;
};

/// The four-bars through `points`, whose condition count must be three and the number of start
/// angles not given. Five conditions have one solution or three, four none or two, three one;
/// complex ones do not count, and outcomes other than a linkage are among them. The coupler of a
/// real solution is real: it is the distance of two real points.
FourBarFunctions four_bar_functions(std::span<const PrecisionPoint> points,
                                    const GivenStart& start);

}  // namespace cognate::synthesis
