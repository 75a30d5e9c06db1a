/// @file Where a search for straight lines begins: linkages of families that are known to have
/// them, by the theory of curvature, and at random, each with the best segment of its sampled
/// curve.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/coupler_curve/sampled_segment.hpp"
#include "problems/straight_line/segment.hpp"

namespace cognate::problems {

/// How a start was drawn.
enum class SegmentFamily {
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
std::string_view name(SegmentFamily family);

/// A start and what it promises: less is better.
struct SegmentStart {
  LinkageSegment segment;
  SegmentFamily family = SegmentFamily::any;
  double score = std::numeric_limits<double>::infinity();
};

/// Draws starts of a problem (in the search's unit); one for each thread.
class SegmentStarts {
 public:
  explicit SegmentStarts(const StraightLineProblem& problem);

  /// The start number `index`, the same for the same seed and index; empty where the linkage drawn
  /// is none that the problem allows, or its curve has no segment worth refining.
  std::optional<SegmentStart> draw(std::uint64_t seed, std::uint64_t index);

 private:
  bool accept(LinkageSegment& drawn) const;
  void bring_to_scale(LinkageSegment& drawn) const;
  bool sample(const LinkageSegment& drawn, bool second_range);
  std::optional<SegmentStart> best_segment(const LinkageSegment& drawn);
  void bring_into_place(SegmentStart& start) const;

  const StraightLineProblem& problem_;
  std::vector<double> angles_;
  std::vector<Vec2d> curve_;
  bool closed_ = false;
  SampledSegments segments_;
};

}  // namespace cognate::problems
