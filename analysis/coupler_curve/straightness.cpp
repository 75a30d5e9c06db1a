#include "analysis/coupler_curve/straightness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {
namespace {

/// The last place towards `to` at which the function is a number, as it is at `from`.
template <class Function>
double last_number(const Function& f, double from, double to) {
  for (;;) {
    const double middle = from + 0.5 * (to - from);
    if (middle == from || middle == to) return from;
    (std::isfinite(f(middle)) ? from : to) = middle;
  }
}

/// How far a function that is positive at `at` stays so in steps towards `limit`.
template <class Function>
double last_positive(const Function& f, double at, double limit) {
  const double sense = limit < at ? -1 : 1;
  constexpr double kStep = kTurn / 720;
  double before = at, value_before = f(at);
  for (int k = 1; before != limit; ++k) {
    double next = at + sense * k * kStep;
    if (sense * (next - limit) >= 0) next = limit;
    double value = f(next);
    const bool ends = !std::isfinite(value);
    if (ends) {
      next = last_number(f, before, next);
      value = f(next);
    }
    if (value <= 0) {
      const auto [low, high] =
          sense > 0 ? bracket_zero(f, before, value_before, next, std::min(value, -1e-300))
                    : bracket_zero(f, next, std::min(value, -1e-300), before, value_before);
      return sense > 0 ? low : high;
    }
    if (ends) return next;
    before = next;
    value_before = value;
  }
  return limit;
}

/// The extent of a path along its tangent at a place, while it keeps near to that.
class TangentReach {
 public:
  TangentReach(const Path& path, double at, const CrankRange& forward)
      : path_(path), at_(at), forward_(forward) {
    const auto [p, rate] = path(at);
    origin_ = p;
    tangent_ = (1 / norm(rate)) * rate;
  }

  /// The parameter up to which, from `at` towards `end`, the distance stays within `bound`.
  double reach(double end, double bound) const {
    double before = at_;
    for (const double place : crowded(at_, end, kCells)) {
      const double peak = peak_between(before, place);
      for (const double next : {peak, place}) {
        const auto excess = [&](double q) { return std::abs(height(q)) - bound; };
        const double here = excess(next), last = excess(before);
        if (here > 0) {
          if (last >= 0) return before;
          const auto [low, high] = before < next ? bracket_zero(excess, before, last, next, here)
                                                 : bracket_zero(excess, next, here, before, last);
          return before < next ? low : high;
        }
        before = next;
      }
    }
    return end;
  }

  double along(double q) const { return dot(tangent_, path_(q).at - origin_); }
  const Vec2d& origin() const { return origin_; }
  const Vec2d& tangent() const { return tangent_; }

 private:
  static constexpr int kCells = 96;

  double height(double q) const { return cross(tangent_, path_(q).at - origin_); }
  double slope(double q) const { return cross(tangent_, path_(q).rate); }

  /// Where the height turns back between two places; the second if nowhere.
  double peak_between(double from, double to) const {
    const double low = std::min(from, to), high = std::max(from, to);
    const double at_low = slope(low), at_high = slope(high);
    if (!(at_low * at_high < 0)) return to;
    return bracket_zero([this](double q) { return slope(q); }, low, at_low, high, at_high).first;
  }

  const Path& path_;
  double at_;
  CrankRange forward_;
  Vec2d origin_, tangent_;
};

}  // namespace

Path path_of(const Mechanism<double>& mechanism, const Attached<double>& point) {
  return [motion = MechanismMotion<1>(mechanism), point](double drive) mutable -> PathPoint {
    if (!motion.move_to(drive)) return {{kNaN, kNaN}, {kNaN, kNaN}};
    const auto p = motion.point(point);
    return {p[0], p[1]};
  };
}

StraightSegment measure(const Path& path, double from, double to) {
  constexpr int kCells = 64, kRounds = 12;
  const Vec2d origin = path(0.5 * (from + to)).at;
  const std::vector<double> places = crowded(from, to, kCells);
  std::vector<Vec2d> points, rates;
  points.reserve(places.size() + 16);
  for (const double place : places) {
    const auto [at, rate] = path(place);
    points.push_back(at - origin);
    rates.push_back(rate);
  }
  const Vec2d first = points.front(), last = points.back();
  StripFinder narrowest;
  NarrowestStrip strip;
  for (int round = 0; round < kRounds; ++round) {
    strip = narrowest(points);
    bool grows = false;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const auto slope = [&](double q) { return cross(strip.direction, path(q).rate); };
      const double before = cross(strip.direction, rates[i - 1]);
      const double after = cross(strip.direction, rates[i]);
      if (!(before * after < 0)) continue;
      const double peak = bracket_zero(slope, places[i - 1], before, places[i], after).first;
      const Vec2d top = path(peak).at - origin;
      const double height = std::abs(cross(strip.direction, top - strip.through));
      constexpr double kGrowth = 1 + 1e-12;
      const double rounding = 4 * std::numeric_limits<double>::epsilon() * norm(last - first);
      if (height > kGrowth * strip.half_width + rounding) {
        points.push_back(top);
        grows = true;
      }
    }
    if (!grows) break;
  }
  const double along = dot(strip.direction, last - first);
  if (along < 0) strip.direction = -strip.direction;
  return {from, to, std::abs(along), strip.half_width, {origin + strip.through, strip.direction}};
}

std::optional<CrankRange> forward_interval(const Path& path, double at, const CrankRange& limits) {
  const auto [p, rate] = path(at);
  const double speed = norm(rate);
  if (!is_finite(p) || !std::isfinite(speed) || speed == 0) return std::nullopt;
  const Vec2d tangent = (1 / speed) * rate;
  const auto forward = [&](double q) { return dot(tangent, path(q).rate); };
  const double from = std::max(limits.from, at - kTurn), to = std::min(limits.to, at + kTurn);
  return CrankRange{last_positive(forward, at, std::min(from, at)),
                    last_positive(forward, at, std::max(to, at))};
}

StraightSegment longest_tangent_segment(const Path& path, double at, const CrankRange& forward,
                                        double relative) {
  const TangentReach reach(path, at, forward);
  // From above: the extent grows with the bound, so that the first that agrees is the largest.
  CrankRange held = forward;
  double bound = std::numeric_limits<double>::infinity(), length = 0;
  constexpr int kRounds = 300;
  for (int round = 0; round < kRounds; ++round) {
    length = reach.along(held.to) - reach.along(held.from);
    const double next = relative * length;
    if (next >= bound * (1 - 1e-13)) break;
    bound = next;
    held = {reach.reach(forward.from, bound), reach.reach(forward.to, bound)};
  }
  return {held.from, held.to, length, bound, {reach.origin(), reach.tangent()}};
}

std::optional<double> speed_variation(const Path& path, const StraightSegment& segment) {
  constexpr int kCells = 256;
  if (!(segment.length > 0)) return std::nullopt;
  std::vector<double> speeds;
  for (int k = 0; k <= kCells; ++k) {
    const double q = segment.from + (segment.to - segment.from) * k / kCells;
    speeds.push_back(dot(segment.line.direction, path(q).rate));
    if (!std::isfinite(speeds.back())) return std::nullopt;
  }
  double low = std::min(speeds.front(), speeds.back()),
         high = std::max(speeds.front(), speeds.back());
  for (std::size_t k = 1; k + 1 < speeds.size(); ++k) {
    // The top of the parabola through three samples.
    const double before = speeds[k] - speeds[k - 1], after = speeds[k + 1] - speeds[k];
    if (before * after > 0) continue;
    const double bend = after - before, slope = 0.5 * (after + before);
    const double top = bend == 0 ? speeds[k] : speeds[k] - slope * slope / (2 * bend);
    low = std::min(low, top);
    high = std::max(high, top);
  }
  return (high - low) * (segment.to - segment.from) / segment.length;
}

}  // namespace cognate
