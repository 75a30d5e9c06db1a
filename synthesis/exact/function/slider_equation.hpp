/// @file The slider-crank's equation at precision points, as rows that its solutions share.
#pragma once

#include <span>

#include "analysis/numbers/vec2.hpp"
#include "synthesis/exact/function/slider_crank_function.hpp"

namespace cognate::synthesis {

/// As for the four-bar: beyond it a length means nothing, and what is no root is dropped.
inline constexpr double kInfiniteSliderRatio = 1e-12;
inline constexpr double kAcceptedSliderResidual = 1e-11;

/// One condition: series coefficients of s², s, su, u and 1 in s² + 2s₀s − 2s Re(Ru) − 2Re(Qu) + C.
struct SliderRow {
  double square = 0, s = 0;
  Vec2d su, u;
  double constant = 0;
};
using SliderRows = InPlaceVector<SliderRow, kMostConditions>;

/// Displacements as s = unit·σ + origin, σ of order one.
struct SliderScale {
  double origin = 0, unit = 1;
};

/// The origin is the middle of the displacements where the start displacement is free to take it
/// up, else the foot of the perpendicular.
SliderScale slider_scale(std::span<const PrecisionPoint> points, const GivenStart& start);

SliderRows slider_rows(std::span<const PrecisionPoint> points, const SliderScale& scale);

/// The equation's coefficients up to a common factor, in the scaled displacement: h·S² − 2r S cos θ
/// − 2w sin θ + c = 0 with w = re, and the starts that go with them.
struct SliderCoefficients {
  double h = 0, r = 0, w = 0, c = 0;
  double input_start = 0, output_start = 0;
};

/// What remains to be known of a solution when the equations are set up.
struct SliderSetting {
  const SliderRows& rows;
  const GivenStart& start;
  const SliderScale& scale;
};

/// Whether the coefficient of S² or that of the crank vanishes in a unit vector of the null space.
SliderCrankOutcome infinite_slider_part(double h, double crank);

/// The mechanism of the coefficients, h = 1, in the unit of the displacements.
SliderCrankFunction slider_linkage(const SliderCoefficients& c, const SliderSetting& setting);

/// Adds a solution that is no linkage; `yoke_crank`: the crank of a Scotch yoke.
void add_slider_limit(SliderCrankOutcome outcome, double yoke_crank, SliderCrankFunctions& result);

}  // namespace cognate::synthesis
