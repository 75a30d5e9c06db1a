#include "problems/path/order_intervals.hpp"

#include <algorithm>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// Prescribed angles closer than this are one, to rounding.
constexpr double kSameAngle = 1e-9;

}  // namespace

double step_forward(double from, double to) {
  const double forward = in_one_turn(to - from);
  return forward < kSameAngle || forward > kTurn - kSameAngle ? 0 : forward;
}

OrderIntervals::OrderIntervals(std::size_t points, std::span<const std::size_t> timed,
                               bool in_order)
    : timed_(timed.begin(), timed.end()), in_order_(in_order) {
  for (std::size_t j = 0; j < points; ++j) {
    if (!std::ranges::binary_search(timed_, j)) untimed_.push_back(j);
  }
  count_ = untimed_.size();
  untimed_.reserve(2 * count_);
  for (std::size_t i = 0; i < count_; ++i) untimed_.push_back(untimed_[i]);
  for (std::size_t k = 0; k < timed_.size(); ++k) before_.push_back(timed_[k] - k);
}

void OrderIntervals::round(std::span<const double> timed_at,
                           std::vector<OrderInterval>& all) const {
  all.clear();
  if (timed_.empty() || !in_order_) {
    all.push_back({.from = 0, .to = kTurn, .is_closed = true, .points = untimed()});
    return;
  }
  for (std::size_t k = 0; k < timed_.size(); ++k) {
    const bool last = k + 1 == timed_.size();
    const std::size_t next = last ? 0 : k + 1;
    const std::size_t end = last ? count_ + before_[0] : before_[next];
    all.push_back({.from = timed_at[k],
                   .to = timed_at[k] + step_forward(timed_at[k], timed_at[next]),
                   .at_start = HeldBy::timed_point,
                   .at_end = HeldBy::timed_point,
                   .timed_before = timed_[k],
                   .timed_after = timed_[next],
                   .points = {untimed_.data() + before_[k], end - before_[k]}});
  }
  // Where the last timed point repeats the first, the turn lies between those with the most points.
  const auto has_step = [](const OrderInterval& interval) { return interval.to > interval.from; };
  if (std::ranges::any_of(all, has_step)) return;
  auto& whole = *std::ranges::max_element(
      all, {}, [](const OrderInterval& interval) { return interval.points.size(); });
  whole.to = whole.from + kTurn;
}

/// Points at an end of the motion where a timed point lies go with that.
void OrderIntervals::end_at_timed(double from, double to, std::span<const double> timed_at,
                                  std::vector<OrderInterval>& all) const {
  for (std::size_t k = 0; k < timed_.size(); ++k) {
    const double place = from + in_one_turn(timed_at[k] - from);
    if (place - from < kSameAngle) {
      all.front().at_start = HeldBy::timed_point;
      all.front().timed_before = timed_[k];
    }
    if (to - place < kSameAngle) {
      all.back().at_end = HeldBy::timed_point;
      all.back().timed_after = timed_[k];
    }
  }
}

bool OrderIntervals::between(double from, double to, std::span<const double> timed_at,
                             std::vector<OrderInterval>& all) const {
  all.clear();
  const bool is_one = timed_.empty() || !in_order_;
  if (is_one) all.push_back({.from = from, .to = to, .points = untimed()});
  double at = from;
  for (std::size_t k = 0; k < timed_.size(); ++k) {
    const double place = from + in_one_turn(timed_at[k] - from);
    if (place > to) return false;
    if (is_one) continue;
    if (k > 0 && place < at - kSameAngle) return false;
    OrderInterval interval{.from = at, .to = k > 0 ? std::max(place, at) : place};
    interval.at_end = HeldBy::timed_point;
    interval.timed_after = timed_[k];
    const std::size_t first = k > 0 ? before_[k - 1] : 0;
    interval.points = untimed().subspan(first, before_[k] - first);
    if (k > 0) {
      interval.at_start = HeldBy::timed_point;
      interval.timed_before = timed_[k - 1];
    }
    at = interval.to;
    all.push_back(interval);
  }
  if (!is_one) {
    all.push_back({.from = at,
                   .to = to,
                   .at_start = HeldBy::timed_point,
                   .timed_before = timed_.back(),
                   .points = untimed().subspan(before_.back())});
  }
  end_at_timed(from, to, timed_at, all);
  return true;
}

}  // namespace cognate::problems
