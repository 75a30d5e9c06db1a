/// @file Roots refined until rounding stops it, with their conditions and residuals.
#pragma once

#include <span>
#include <vector>

#include "synthesis/exact/nine_point/path_parameters.hpp"
#include "synthesis/exact/nine_point/tracker.hpp"

namespace cognate::synthesis::nine_point {

/// What is known of a root once it is refined.
struct RootQuality {
  double condition = 0;   ///< Frobenius norm of the derivative of the pivots by the data
  double correction = 0;  ///< Newton's last one, relative to 1 + |unknown|
  double residual = 0;    ///< see position_error()
};

/// Refines roots in place, those that are badly conditioned by residuals of 32 digits.
std::vector<RootQuality> refine(std::span<Pair> roots, const PathParameters& data,
                                const TrackingOptions& means);

/// The same of roots as they are.
std::vector<RootQuality> measure(std::span<const Pair> roots, const PathParameters& data,
                                 const TrackingOptions& means);

/// The largest position_miss() of a root; not a number where one is none. `values` are those of f
/// and g, two for each position.
double position_error(std::span<const Pair> root, const PathParameters& data,
                      std::span<const Pair> values);

}  // namespace cognate::synthesis::nine_point
