/// @file The longest straight segment of a closed curve that is known by samples and derivatives.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/coupler_curve/circuit_samples.hpp"
#include "analysis/coupler_curve/sampled_segment.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// Number of samples that resolve the segments of δ/L = `relative`: the narrower the
/// strip, the shorter they are.
constexpr std::size_t samples_for_segments(double relative) {
  return relative < 5e-3 ? 1024 : 256;
}

/// Finds segments; keeps its room from curve to curve. The longest between two of the samples says
/// where to look; there the curve is taken for the cubics through its points and derivatives, and
/// ends and deviation are those of some sixty points of them.
class ClosedSegmentFinder {
 public:
  /// The length of the longest segment with δ ≤ `relative`·L.
  double operator()(const CurveSamples& curve, double relative);

 private:
  void lay_out(const CurveSamples& curve);
  /// `pieces` points of each of the `cells` steps from sample `first` on.
  void refine(const CurveSamples& curve, std::size_t first, std::size_t cells, std::size_t pieces);

  SampledSegments segments_;
  std::vector<Vec2d> points_, fine_;
};

}  // namespace cognate
