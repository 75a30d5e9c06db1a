/// @file A slider-crank as a function generator, and how far it is from what is requested.
#pragma once

#include <optional>
#include <vector>

#include "analysis/linkage/slider_crank.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Displacement at the start.
inline constexpr QuantityKey<double> kSliderStartKey{"output_start"};

/// A slider-crank with its pivot at the origin and its slide along x, and where input and
/// displacement are counted from: the crank's angle from the slide direction, the displacement from
/// the foot of the perpendicular from the pivot.
struct SliderGenerator {
  SliderCrank mechanism;
  double input_start = 0;
  double output_start = 0;
};

/// Displacement obtained minus wanted; empty where the mechanism does not close.
std::optional<double> displacement_error(const SliderGenerator& generator,
                                         const synthesis::AnglePair& wanted);

/// Whether the crank turns over the whole of `sweep`, increments from its start, by its ranges.
bool closes_over(const SliderGenerator& generator, const Range& sweep);

/// Σ e², its root mean and max |e| over the samples, the maximum over the whole domain for
/// functions where the mechanism closes over it; infinite where it does not close at a sample.
TargetError displacement_error_over(const SliderGenerator& generator,
                                    const FunctionSamples& wanted);

/// Whether the pin is ahead of the crank pin (`open`) at each point, by the positions wanted.
std::vector<Assembly> sides_of(const SliderGenerator& generator,
                               const std::vector<synthesis::PrecisionPoint>& points);

/// What the analysis kernel says of a generator that moves over `sweep` (input increments), with
/// the points on `sides`. The transmission angle is that between coupler and the normal of the
/// slide, π/2 less the pressure angle; the stroke is that of the motion, beside that of the whole
/// circuit.
Metrics slider_metrics(const SliderGenerator& generator, const Range& sweep,
                       const std::vector<Assembly>& sides);

}  // namespace cognate::problems
