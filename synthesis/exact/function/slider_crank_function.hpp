/// @file Slider-cranks as function generators through three, four or five precision points.
///
/// With crank r, coupler l, offset e (positive to the left of the slide direction), input θ = φ +
/// φ₀ from the slide direction and displacement S = s + s₀ from the foot of the perpendicular from
/// the pivot, the closure without the coupler's angle is
///
///     S² − 2r S cos θ − 2re sin θ + r² + e² − l² = 0:
///
/// linear in r, re and r² + e² − l², the slider's analogue of Freudenstein's equation (Hartenberg
/// and Denavit 1964). With R = re^{iφ₀}, Q = (s₀ − ie)R and u = e^{iφ} it is
///
///     s² + 2s₀ s − 2s Re(Ru) − 2 Re(Qu) + C = 0,   C = s₀² + r² + e² − l²,
///
/// linear in s₀, R, Q and C, and so is each of its derivatives by the input. That Re(Q conj R) =
/// s₀|R|² is a cubic on the plane that five conditions leave, and where the start angle or the
/// start displacement is given four leave a quadratic. With e given it is linear in R, s₀R, s₀ and
/// C: three conditions leave a quadratic where the start angle is given, one solution where the
/// start displacement is, and four a cubic of s₀ where neither is. Displacements are centred and
/// scaled, so that neither their unit nor their origin matters.
#pragma once

#include <span>

#include "synthesis/exact/function/precision_point.hpp"
#include "synthesis/exact/in_place_vector.hpp"

namespace cognate::synthesis {

/// What a solution of the equations is as a mechanism.
enum class SliderCrankOutcome {
  linkage,         ///< crank and coupler are positive and finite
  no_coupler,      ///< the coupler has no length
  no_crank,        ///< the crank has no length: the slider would stand still
  scotch_yoke,     ///< coupler infinitely long, s harmonic in φ: a Scotch yoke
  infinite_links,  ///< crank and coupler both infinitely long
};

/// One real solution, in the unit of the displacements.
struct SliderCrankFunction {
  SliderCrankOutcome outcome = SliderCrankOutcome::linkage;
  double crank = 0;  ///< of a Scotch yoke too
  double coupler = 0;
  double offset = 0;          ///< positive to the left of the slide direction
  double input_start = 0;     ///< of the crank from the slide direction, at input 0
  double output_start = 0;    ///< displacement from the foot of the perpendicular, at output 0
  bool input_turned = false;  ///< the crank points away from where the given start angle has it
  double residual = 0;        ///< as of `FourBarFunction`
  double condition = 0;
};

/// All solutions, or word that there are infinitely many.
struct SliderCrankFunctions {
  bool dependent = false;  ///< the conditions are dependent to within rounding
  InPlaceVector<SliderCrankFunction, 3> solutions;
};

/// The slider-cranks through `points`, whose outputs are displacements along the slide (derivatives
/// of displacement per radian), and whose condition count must be three and the number of starts
/// not given. Outcomes other than a linkage are among the solutions.
SliderCrankFunctions slider_crank_functions(std::span<const PrecisionPoint> points,
                                            const GivenStart& start);

/// The same with the offset given too, so that one condition less is needed: three with one of the
/// starts given, four with none. At least one start must be free.
SliderCrankFunctions slider_crank_functions(std::span<const PrecisionPoint> points,
                                            const GivenStart& start, double offset);

}  // namespace cognate::synthesis
