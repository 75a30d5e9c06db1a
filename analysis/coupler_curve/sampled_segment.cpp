#include "analysis/coupler_curve/sampled_segment.hpp"

#include <algorithm>
#include <cmath>

namespace cognate {

void SampledSegments::lay_out(std::span<const Vec2d> curve, bool closed) {
  count_ = curve.size();
  points_.assign(curve.begin(), curve.end());
  if (closed && count_ > 1) points_.insert(points_.end(), curve.begin(), curve.end() - 1);
  Vec2d low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Vec2d& p : curve) {
    low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y)};
    high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y)};
  }
  squared_size_ = squared_norm(high - low);
  breaks_.resize(points_.size());
  std::size_t next = points_.size();
  for (std::size_t i = points_.size(); i-- > 0;) {
    if (!std::isfinite(points_[i].x) || !std::isfinite(points_[i].y)) next = i;
    breaks_[i] = next;
  }
}

/// The last sample up to which a segment from `from` may go; `from` itself if there is none.
std::size_t SampledSegments::last_from(std::size_t from, const SegmentLimits& limits) const {
  if (breaks_[from] <= from) return from;
  const std::size_t most = std::min(limits.most_cells, count_ - 1);
  return std::min(breaks_[from] - 1, from + most);
}

/// Whether the strip is known to be wider: the width of a triangle is its area twice over its
/// longest side.
bool SampledSegments::is_wider(std::size_t from, std::size_t to, double squared_width) const {
  const Vec2d chord = points_[to] - points_[from];
  const double squared_chord = squared_norm(chord);
  for (const std::size_t k : {4, 2, 6, 1, 3, 5, 7}) {
    const Vec2d side = points_[from + (to - from) * k / 8] - points_[from];
    const double longest =
        std::max({squared_chord, squared_norm(side), squared_norm(chord - side)});
    const double area = cross(chord, side);
    if (area * area > squared_width * longest) return true;
  }
  return false;
}

/// A sample up to `last` beyond which every segment from `from` is wider: one that holds a wider
/// one is wider itself.
std::size_t SampledSegments::last_narrow(std::size_t from, std::size_t last,
                                         double squared_width) const {
  if (last <= from) return from;
  std::size_t narrow = from, wide = last + 1;
  for (std::size_t step = 2; from + step <= last; step *= 2) {
    if (is_wider(from, from + step, squared_width)) {
      wide = from + step;
      break;
    }
    narrow = from + step;
  }
  while (wide - narrow > 1) {
    const std::size_t middle = narrow + (wide - narrow) / 2;
    (is_wider(from, middle, squared_width) ? wide : narrow) = middle;
  }
  return narrow;
}

SampledSegment SampledSegments::between(std::size_t from, std::size_t to) {
  const auto begin = points_.begin();
  room_.assign(begin + static_cast<std::ptrdiff_t>(from),
               begin + static_cast<std::ptrdiff_t>(to) + 1);
  const NarrowestStrip strip = narrowest_(room_);
  const double along = dot(strip.direction, points_[to] - points_[from]);
  return {from, to, std::abs(along), strip.half_width,
          along < 0 ? -strip.direction : strip.direction};
}

template <class TooShort, class Wins>
SampledSegment SampledSegments::best_of(std::span<const Vec2d> curve, bool closed,
                                        const double& relative, const SegmentLimits& limits,
                                        TooShort too_short, Wins wins) {
  lay_out(curve, closed);
  const std::size_t least_cells = std::max<std::size_t>(limits.least_cells, 1);
  const double width = 2 * limits.deviation;
  SampledSegment best;
  for (std::size_t i = 0; i < count_; ++i) {
    const double widest = std::min(width * width, 4 * relative * relative * squared_size_);
    for (std::size_t j = last_narrow(i, last_from(i, limits), widest); j >= i + least_cells; --j) {
      const double chord = squared_norm(points_[j] - points_[i]);
      if (too_short(chord, best)) continue;
      const double most = std::min(width * width, 4 * relative * relative * chord);
      if (is_wider(i, j, most)) continue;
      const SampledSegment found = between(i, j);
      if (found.deviation <= limits.deviation && wins(found, best)) best = found;
    }
  }
  return best;
}

SampledSegment SampledSegments::longest(std::span<const Vec2d> curve, bool closed, double relative,
                                        const SegmentLimits& limits) {
  return best_of(
      curve, closed, relative, limits,
      [](double chord, const SampledSegment& best) { return chord <= best.length * best.length; },
      [&](const SampledSegment& found, const SampledSegment& best) {
        return found.deviation <= relative * found.length && found.length > best.length;
      });
}

SampledSegment SampledSegments::straightest(std::span<const Vec2d> curve, bool closed,
                                            double length, double relative,
                                            const SegmentLimits& limits) {
  return best_of(
      curve, closed, relative, limits,
      [&](double chord, const SampledSegment&) { return chord < length * length || chord == 0; },
      [&](const SampledSegment& found, const SampledSegment&) {
        if (found.length < length || !(found.deviation < relative * found.length)) return false;
        relative = found.deviation / found.length;  // what follows has to be straighter
        return true;
      });
}

}  // namespace cognate
