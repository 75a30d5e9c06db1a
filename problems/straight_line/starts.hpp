/// @file Where a search for straight lines begins: linkages of families that are known to have
/// them, by the theory of curvature, and at random, each with the best stretch of its sampled
/// curve.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/coupler_curve/sampled_stretch.hpp"
#include "problems/straight_line/stretch.hpp"

namespace cognate::problems {

/// How a start was drawn.
enum class StretchFamily {
  any,               ///< all dimensions at random
  symmetric_curve,   ///< coupler, rocker and C–P equal: a coupler curve with an axis of symmetry
  equal_cranks,      ///< crank and rocker equal, the point on the coupler's perpendicular bisector
  on_coupler_line,   ///< the point in line with B and C
  ball_point,        ///< Ball's point of a position: four-point contact
  parallel_cranks,   ///< cranks parallel, coupler across them: five-point contact
  isosceles_slider,  ///< slider-crank: crank, coupler and B–P equal
  count
};

/// "any", "symmetric-curve", …
std::string_view name(StretchFamily family);

/// A start and what it promises: less is better.
struct StretchStart {
  LineStretch stretch;
  StretchFamily family = StretchFamily::any;
  double score = std::numeric_limits<double>::infinity();
};

/// Draws starts of a problem (in the search's unit); one for each thread.
class StretchStarts {
 public:
  explicit StretchStarts(const StraightLineProblem& problem);

  /// The start number `index`, the same for the same seed and index; empty where the linkage drawn
  /// is none that the problem allows, or its curve has no stretch worth refining.
  std::optional<StretchStart> draw(std::uint64_t seed, std::uint64_t index);

 private:
  bool accept(LineStretch& drawn) const;
  void bring_to_scale(LineStretch& drawn) const;
  bool sample(const LineStretch& drawn, bool second_range);
  std::optional<StretchStart> best_stretch(const LineStretch& drawn);

  const StraightLineProblem& problem_;
  std::vector<double> angles_;
  std::vector<Vec2d> curve_;
  bool closed_ = false;
  SampledStretches stretches_;
};

}  // namespace cognate::problems
