#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {
namespace {

constexpr double kGolden = 0.6180339887498949;

/// Samples of a path about a place, and the pairs of them between which it is straight enough. The
/// width of the strip only grows with the segment, but so does its length: the segments that are
/// straight enough need not be connected, and all pairs are looked at, the longest first.
class SegmentsAround {
 public:
  SegmentsAround(const Path& path, double at, const CrankRange& forward, double relative)
      : relative_(relative) {
    const auto [origin, rate] = path(at);
    const Vec2d to_tangent = conj((1 / norm(rate)) * rate);
    places_ = crowded(forward.from, at, kSide);
    const auto right = crowded(at, forward.to, kSide);
    places_.insert(places_.end(), right.begin() + 1, right.end());
    for (const double place : places_) points_.push_back(to_tangent * (path(place).at - origin));
  }

  /// Indices of the ends of the longest, the left at most and the right at least the middle's.
  std::pair<std::size_t, std::size_t> longest() {
    std::pair<std::size_t, std::size_t> best{kMiddle, kMiddle};
    double length = 0;
    for (std::size_t i = 0; i <= kMiddle; ++i) {
      for (std::size_t j = points_.size(); j-- > kMiddle;) {
        if (norm(points_[j] - points_[i]) <= length) continue;
        const double found = straight_length(i, j);
        if (found <= length) continue;
        length = found;
        best = {i, j};
      }
    }
    return best;
  }

  double place(std::size_t i) const { return places_[std::min(i, places_.size() - 1)]; }

  static constexpr int kSide = 72;
  static constexpr std::size_t kMiddle = kSide;

 private:
  /// The length between two samples; zero if what lies between is not straight enough.
  double straight_length(std::size_t i, std::size_t j) {
    if (is_bent(i, j)) return 0;
    between_.assign(points_.begin() + static_cast<std::ptrdiff_t>(i),
                    points_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    const Vec2d chord = between_.back() - between_.front();
    const NarrowestStrip strip = narrowest_(between_);
    const double length = std::abs(dot(strip.direction, chord));
    return strip.half_width <= relative_ * length ? length : 0;
  }

  /// Whether three of the points alone need a wider strip: the least height of their triangle.
  bool is_bent(std::size_t i, std::size_t j) const {
    const Vec2d chord = points_[j] - points_[i];
    const double length = norm(chord);
    for (std::size_t k = 1; k < 8; ++k) {
      const Vec2d side = points_[i + (j - i) * k / 8] - points_[i];
      const double longest = std::max({length, norm(side), norm(chord - side)});
      if (std::abs(cross(chord, side)) > 2 * relative_ * length * longest) return true;
    }
    return false;
  }

  double relative_;
  std::vector<double> places_;
  std::vector<Vec2d> points_, between_;
  StripFinder narrowest_;
};

/// A segment and how good it is: its length, or what is missing from its being straight enough.
struct Candidate {
  StraightSegment segment;
  double score = 0;

  friend bool operator<(const Candidate& a, const Candidate& b) { return a.score < b.score; }
};

/// Refines the ends of a segment: the right end as far as it goes, the left where that is longest.
/// The longest often stands in a corner where hardly another with either end is straight enough.
class EndRefinement {
 public:
  EndRefinement(const Path& path, double relative, const CrankRange& right)
      : path_(path), relative_(relative), right_(right) {}

  /// The longest segment from `left`, or the one nearest to being straight enough.
  Candidate from(double left) const {
    constexpr int kProbes = 8;
    const double step = (right_.to - right_.from) / kProbes;
    Candidate best = candidate(left, right_.to);
    if (best.score >= 0) return best;
    for (int k = kProbes - 1; k >= 0; --k) {
      const double probe = right_.from + k * step;
      const Candidate found = candidate(left, probe);
      if (found.score >= 0) return last_between(left, probe, probe + step);
      if (best < found) best = found;
    }
    const double middle = best.segment.to;
    best =
        straightest(left, std::max(right_.from, middle - step), std::min(right_.to, middle + step));
    return best.score < 0 ? best : last_between(left, best.segment.to, middle + step);
  }

 private:
  double excess(const StraightSegment& segment) const {
    return segment.deviation - relative_ * segment.length;
  }

  Candidate candidate(double left, double right) const {
    const StraightSegment segment = measure(path_, left, right);
    const double missing = excess(segment);
    return {segment, missing <= 0 ? segment.length : -missing};
  }

  /// The right end is good at `good` and not at `refused`.
  Candidate last_between(double left, double good, double refused) const {
    const auto f = [&](double right) { return excess(measure(path_, left, right)); };
    const double at_good = f(good), at_refused = f(refused);
    if (!(at_good < 0 && at_refused > 0)) return candidate(left, good);
    const auto [last, next] = bracket_zero(f, good, at_good, refused, at_refused);
    return candidate(left, last);
  }

  /// By golden section, until one is straight enough.
  Candidate straightest(double left, double low, double high) const {
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    Candidate at_a = candidate(left, a), at_b = candidate(left, b);
    for (int step = 0; step < kSteps && at_a.score < 0 && at_b.score < 0; ++step) {
      if (at_b < at_a) {
        high = std::exchange(b, a);
        at_b = at_a;
        a = high - kGolden * (high - low);
        at_a = candidate(left, a);
      } else {
        low = std::exchange(a, b);
        at_a = at_b;
        b = low + kGolden * (high - low);
        at_b = candidate(left, b);
      }
    }
    return std::max(at_a, at_b);
  }

  static constexpr int kSteps = 24;

  const Path& path_;
  double relative_;
  CrankRange right_;
};

/// The best segment whose left end lies between two places, or `best`.
Candidate golden_section(const EndRefinement& ends, Candidate best, double low, double high) {
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  Candidate at_a = ends.from(a), at_b = ends.from(b);
  constexpr int kSteps = 36;
  for (int step = 0; step < kSteps; ++step) {
    best = std::max({best, at_a, at_b});
    if (at_b < at_a) {
      high = std::exchange(b, a);
      at_b = at_a;
      a = high - kGolden * (high - low);
      at_a = ends.from(a);
    } else {
      low = std::exchange(a, b);
      at_a = at_b;
      b = low + kGolden * (high - low);
      at_b = ends.from(b);
    }
  }
  return best;
}

}  // namespace

StraightSegment longest_segment(const Path& path, double at, const CrankRange& forward,
                                double relative) {
  SegmentsAround samples(path, at, forward, relative);
  const auto [i, j] = samples.longest();
  // The longest of the sampled pairs may be some cells beside the longest of all segments.
  constexpr std::size_t kNear = 4;
  const std::size_t middle = SegmentsAround::kMiddle;
  const double right_from = samples.place(std::max(j, middle + kNear) - kNear);
  const EndRefinement ends(path, relative, {right_from, samples.place(j + kNear)});
  const double left_from = samples.place(i - std::min(i, kNear));
  const double left_to = samples.place(std::min(i + kNear, middle));
  constexpr int kProbes = 16;
  const double step = (left_to - left_from) / kProbes;
  Candidate best = ends.from(left_to);
  for (int k = 0; k < kProbes; ++k) best = std::max(best, ends.from(left_from + k * step));
  best = golden_section(ends, best, std::max(left_from, best.segment.from - step),
                        std::min(left_to, best.segment.from + step));
  return best.score < 0 ? StraightSegment{at, at, 0, 0, best.segment.line} : best.segment;
}

}  // namespace cognate
