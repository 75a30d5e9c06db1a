/// @file The extremes of a function over a box, to a sound bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "synthesis/bounds/interval.hpp"

namespace cognate::synthesis {

/// `value(x)` at a point, and `slopes(box, out)`: intervals that hold every derivative over the
/// box; false where there is none, the function not being smooth there.
template <class F>
concept BoxFunction = requires(F f, std::span<const double> x, std::span<const Interval> box,
                               std::span<Interval> out) {
  { f.value(x) } -> std::convertible_to<double>;
  { f.slopes(box, out) } -> std::same_as<bool>;
};

/// Where and when a search over a box ends.
struct BoxOptions {
  double gap_relative = 1e-11;  ///< of the variation that the slopes over the whole box allow
  std::size_t boxes = 20000;    ///< at most
};

/// The greatest value of a function over a box.
struct BoxMaximum {
  bool determined = false;  ///< else the function is not smooth somewhere in the box
  double reached = 0;       ///< at a point of the box
  double bound = 0;         ///< no value is greater; equal to `reached` but for the gap
  bool complete = false;    ///< the gap was reached
  std::size_t boxes = 0;    ///< that were examined
};

/// Branch and bound. A variable in which the function is monotone over a box is set to an end of
/// its range; where all are, the corner has the maximum. What is left is bounded by the mean value
/// form, f(x) ≤ f(c) + Σ |f′ᵢ| rᵢ, and split.
template <BoxFunction F>
class BoxSearch {
 public:
  BoxSearch(F& function, const BoxOptions& options) : function_(function), options_(options) {}

  BoxMaximum maximum(std::vector<Interval> box) {
    best_.reached = -std::numeric_limits<double>::infinity();
    examine(std::move(box));
    const double gap = options_.gap_relative * variation_;
    while (!open_.empty()) {
      Part part = std::move(const_cast<Part&>(open_.top()));  // popped at once
      open_.pop();
      const bool near = part.bound - best_.reached <= gap;
      if (near || best_.boxes >= options_.boxes) {
        best_.bound = std::max(part.bound, best_.reached);
        best_.complete = near;
        best_.determined = std::isfinite(best_.bound);
        return best_;
      }
      auto [low, high] = halves(part);
      examine(std::move(low));
      examine(std::move(high));
      if (++steps_without_slopes_ > kMostWithoutSlopes && part.slopes.empty())
        return undetermined();
      if (!part.slopes.empty()) steps_without_slopes_ = 0;
    }
    best_.bound = best_.reached;
    best_.complete = best_.determined = true;
    return best_;
  }

 private:
  /// So many splits in a row of boxes without slopes show a place where there are none.
  static constexpr int kMostWithoutSlopes = 64;

  struct Part {
    double bound = 0;
    std::vector<Interval> box;
    std::vector<Interval> slopes;  ///< empty where there are none
    bool operator<(const Part& other) const { return bound < other.bound; }
  };

  BoxMaximum undetermined() {
    best_.bound = std::numeric_limits<double>::infinity();
    best_.determined = best_.complete = false;
    return best_;
  }

  void consider(std::span<const double> x) {
    best_.reached = std::max(best_.reached, function_.value(x));
  }

  void examine(std::vector<Interval> box) {
    ++best_.boxes;
    Part part{std::numeric_limits<double>::infinity(), std::move(box), {}};
    std::vector<Interval> slopes(part.box.size());
    if (!function_.slopes(part.box, slopes)) {
      open_.push(std::move(part));
      return;
    }
    std::vector<double> middle(part.box.size()), corner(part.box.size());
    double variation = 0, left = 0;
    bool all_fixed = true;
    for (std::size_t i = 0; i < part.box.size(); ++i) {
      Interval& side = part.box[i];
      variation += slopes[i].magnitude() * side.radius();
      if (slopes[i].low >= 0) side = Interval(side.high);
      if (slopes[i].high <= 0) side = Interval(side.low);
      middle[i] = side.middle();
      corner[i] = slopes[i].middle() > 0 ? side.high : side.low;
      if (side.low < side.high) {
        all_fixed = false;
        left += slopes[i].magnitude() * side.radius();
      }
    }
    if (best_.boxes == 1) variation_ = variation;
    consider(corner);
    if (all_fixed) return;
    consider(middle);
    part.bound = Interval::above(function_.value(middle) + Interval::above(left));
    if (part.bound <= best_.reached) return;
    part.slopes = std::move(slopes);
    open_.push(std::move(part));
  }

  /// Split where the slope varies the value most, or without slopes the widest side of all.
  static std::pair<std::vector<Interval>, std::vector<Interval>> halves(const Part& part) {
    const auto weight = [&](std::size_t i) {
      const double width = part.box[i].high - part.box[i].low;
      return part.slopes.empty() ? width : width * part.slopes[i].magnitude();
    };
    std::size_t widest = 0;
    for (std::size_t i = 1; i < part.box.size(); ++i) {
      if (weight(i) > weight(widest)) widest = i;
    }
    std::vector<Interval> low = part.box, high = part.box;
    const double middle = part.box[widest].middle();
    low[widest].high = middle;
    high[widest].low = middle;
    return {std::move(low), std::move(high)};
  }

  F& function_;
  BoxOptions options_;
  BoxMaximum best_;
  double variation_ = 0;
  int steps_without_slopes_ = 0;
  std::priority_queue<Part> open_;
};

/// The greatest value of `function` over `box`.
template <BoxFunction F>
BoxMaximum box_maximum(F& function, std::span<const Interval> box, const BoxOptions& options = {}) {
  return BoxSearch<F>(function, options).maximum({box.begin(), box.end()});
}

/// The negative of a function, whose maximum is the function's least value negated.
template <BoxFunction F>
struct Negative {
  F& function;

  double value(std::span<const double> x) { return -function.value(x); }
  bool slopes(std::span<const Interval> box, std::span<Interval> out) {
    if (!function.slopes(box, out)) return false;
    for (Interval& slope : out) slope = -slope;
    return true;
  }
};

}  // namespace cognate::synthesis
