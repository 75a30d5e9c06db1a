/// @file What a function generator must do, as pairs of angles counted from the start angles.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "problems/function/problem.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "synthesis/exact/freudenstein.hpp"
#include "synthesis/exact/function/precision_point.hpp"

namespace cognate::problems {

/// The wanted increments of input and output angle, in radians; for a slider-crank the output is
/// the increment of displacement.
///
/// With ranges, x is carried linearly to [0, input_range] and y to the output so that the ends of
/// the domain give 0 and output_range; with relation = "angles" x and y are the increments.
struct FunctionSamples {
  std::vector<synthesis::AnglePair> samples;         ///< where the error counts
  std::vector<synthesis::PrecisionPoint> precision;  ///< those of exact synthesis, else empty
  /// Of derivatives that were found numerically: their estimated error relative to their size.
  double derivative_error = 0;
  std::vector<synthesis::AnglePair> range;  ///< the whole domain in equal steps; empty for pairs
  /// Places, by their share of the domain, by which those steps have to be parted where the
  /// function is too fast for them; see target/fast_places.hpp.
  std::vector<std::pair<double, synthesis::AnglePair>> between;
  /// The pair at a share (0…1) of the domain; threads that call it wait for one another. Empty for
  /// angle pairs.
  std::function<synthesis::AnglePair(double share)> at;
  Range sweep;  ///< least and greatest input increment of the motion
};

/// Number of steps in which the domain is scanned for the largest structural error.
inline constexpr int kRangeSteps = 200;

FunctionSamples function_samples(const FunctionProblem& problem);

}  // namespace cognate::problems
