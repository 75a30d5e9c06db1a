#include "problems/toml/derivative.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace cognate::problems::reading {
namespace {

constexpr double kGreatestStep = 0.01;
constexpr int kMostHalvings = 12;
constexpr double kPlainStep = kGreatestStep / (1 << kMostHalvings);
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// How many roundings of f two differences may lie apart; and how far, in parts of both f and its
// slope, an eighth-order difference may lie from the plain one.
constexpr double kRoundings = 16, kRough = 1e-3;

// Differences of f about a place.
class Differences {
 public:
  Differences(const std::function<double(double)>& f, double x) : f_(f), x_(x) {}

  // f(x + step) − f(x − step).
  double across(double step) {
    const double after = f_(x_ + step), before = f_(x_ - step);
    size_ = std::max({size_, std::abs(after), std::abs(before)});
    return after - before;
  }

  // With two of the four differences of the step before, which was twice as long.
  double of_order_8(double step) {
    const std::array<double, 4> weights{4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    across_ = known_
                  ? std::array{across(step), across_[0], across(3 * step), across_[1]}
                  : std::array{across(step), across(2 * step), across(3 * step), across(4 * step)};
    known_ = true;
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * across_[i];
    return sum / step;
  }

  double size() const { return size_; }  // of f

 private:
  const std::function<double(double)>& f_;
  double x_;
  std::array<double, 4> across_{};
  bool known_ = false;
  double size_ = 0;
};

double slope(const std::function<double(double)>& f, double x) {
  Differences differences(f, x);
  const double plain = differences.across(kPlainStep) / (2 * kPlainStep);
  double before = differences.of_order_8(kGreatestStep);
  double best = before, least_change = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= kMostHalvings; ++i) {
    const double step = std::ldexp(kGreatestStep, -i);
    const double now = differences.of_order_8(step);
    const double change = std::abs(now - before);
    const double rounding = kRoundings * kEpsilon * differences.size() / step;
    const bool is_near = std::abs(now - plain) <= kRough * (std::abs(plain) + differences.size());
    if (is_near && change < least_change) {
      best = now;
      least_change = change;
    }
    if (is_near && change <= rounding) return now;
    before = now;
  }
  return std::isinf(least_change) ? plain : best;
}

}  // namespace

std::function<double(double)> derivative(std::function<double(double)> f) {
  return [f = std::move(f)](double x) { return slope(f, x); };
}

}  // namespace cognate::problems::reading
