/// @file The parts of a crank's motion between points that are timed, and the points met in each.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "problems/path/order.hpp"

namespace cognate::problems {

/// From one angle forward to another; angles that are equal but for rounding have none between.
double step_forward(double from, double to);

/// A part of the motion, and the points met there one after the other.
struct OrderInterval {
  double from = 0, to = 0;  ///< along the motion: `sense` times the crank angle
  HeldBy at_start = HeldBy::range_end, at_end = HeldBy::range_end;
  std::size_t timed_before = 0, timed_after = 0;
  bool is_closed = false;               ///< a whole turn that may begin anywhere
  std::span<const std::size_t> points;  ///< in the order in which they are met
};

/// The intervals of a motion in which timed points are passed in their order.
class OrderIntervals {
 public:
  /// `timed`: ascending, of `points`.
  OrderIntervals(std::size_t points, std::span<const std::size_t> timed, bool in_order);

  /// Those of a crank that turns fully, whose timed points lie at `timed_at` along the motion.
  void round(std::span<const double> timed_at, std::vector<OrderInterval>& all) const;

  /// Those of one that goes from `from` to `to` only; false where it cannot pass the timed points
  /// in order.
  bool between(double from, double to, std::span<const double> timed_at,
               std::vector<OrderInterval>& all) const;

 private:
  std::span<const std::size_t> untimed() const { return {untimed_.data(), count_}; }

  void end_at_timed(double from, double to, std::span<const double> timed_at,
                    std::vector<OrderInterval>& all) const;

  std::vector<std::size_t> timed_;
  std::vector<std::size_t> untimed_;  ///< ascending, twice: all that follow any are in one piece
  std::vector<std::size_t> before_;   ///< how many untimed points come before each timed one
  std::size_t count_ = 0;             ///< of untimed points
  bool in_order_;
};

}  // namespace cognate::problems
