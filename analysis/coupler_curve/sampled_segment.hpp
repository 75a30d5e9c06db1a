/// @file The straight segments of a curve that is known by samples: what a search over many curves
/// screens them by. `straightness.hpp` measures a segment of the curve itself.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "analysis/coupler_curve/narrowest_strip.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// The samples `from` … `to` of a curve. On a closed curve, `to` may pass the last sample: the
/// indices then go on from the curve's first. Length and deviation as `straightness.hpp` has them,
/// of the samples; `direction` is the unit vector along the best line, from the first sample to the
/// last. Of length 0 where there is no segment.
struct SampledSegment {
  std::size_t from = 0;
  std::size_t to = 0;
  double length = 0;
  double deviation = 0;
  Vec2d direction{1, 0};
};

/// What limits the segments that are looked at.
struct SegmentLimits {
  std::size_t least_cells = 1;  ///< steps between samples
  std::size_t most_cells = std::numeric_limits<std::size_t>::max();
  double deviation = std::numeric_limits<double>::infinity();  ///< greatest δ
};

/// Finds segments; keeps its room from one curve to the next, so that curves of one number of
/// samples cost no allocation but the first. A closed curve (its last sample is not its first
/// again) has segments of up to all samples; no segment holds a sample that is not a number, as
/// where a linkage does not close.
///
/// All pairs of ends are looked at, since neither length nor δ/L grows with the segment; most fall
/// to bounds: the length is at most the chord; the strip is at least as wide as the least height of
/// a triangle of three of the samples, and as that of any part of the segment.
class SampledSegments {
 public:
  /// The longest segment with δ ≤ `relative`·L.
  SampledSegment longest(std::span<const Vec2d> curve, bool closed, double relative,
                         const SegmentLimits& limits = {});

  /// The segment of least δ/L, less than `relative`, among those at least `length` long.
  SampledSegment straightest(std::span<const Vec2d> curve, bool closed, double length,
                             double relative, const SegmentLimits& limits = {});

 private:
  void lay_out(std::span<const Vec2d> curve, bool closed);
  std::size_t last_from(std::size_t from, const SegmentLimits& limits) const;
  std::size_t last_narrow(std::size_t from, std::size_t last, double squared_width) const;
  bool is_wider(std::size_t from, std::size_t to, double squared_width) const;
  SampledSegment between(std::size_t from, std::size_t to);
  /// The best by `wins` of the segments of the curve with δ ≤ `relative`·L at most, which may fall
  /// on the way, but for those whose squared chord is `too_short`.
  template <class TooShort, class Wins>
  SampledSegment best_of(std::span<const Vec2d> curve, bool closed, const double& relative,
                         const SegmentLimits& limits, TooShort too_short, Wins wins);

  std::size_t count_ = 0;            ///< samples of the curve
  double squared_size_ = 0;          ///< of the diagonal of the box that holds them
  std::vector<Vec2d> points_;        ///< of a closed curve twice but for the last
  std::vector<std::size_t> breaks_;  ///< for each point the first at or after it that is none
  std::vector<Vec2d> room_;
  StripFinder narrowest_;
};

}  // namespace cognate
