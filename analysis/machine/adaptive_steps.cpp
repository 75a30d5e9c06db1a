#include "analysis/machine/adaptive_steps.hpp"

#include <algorithm>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

namespace cognate::machine {
namespace {

using State = AdaptiveSteps::State;
namespace odeint = boost::numeric::odeint;
using DormandPrince =
    odeint::runge_kutta_dopri5<State, double, State, double, odeint::array_algebra,
                               odeint::default_operations, odeint::never_resizer>;

/// The share of `limit` − x with which an integration begins.
constexpr double kFirst = 1e-3;
/// Steps grow and shrink by these factors at most; the error of a method of order 5 goes with the
/// fifth power of the step.
constexpr double kGrow = 5, kShrink = 0.2, kCaution = 0.9;
/// Of an implicit method: the step of differences by x, in steps; and the shortest step that is
/// tried again.
constexpr double kDifference = 1e-5, kUnresolved = 1e-14;

bool is_finite(const State& y) {
  return std::ranges::all_of(y, [](double component) { return std::isfinite(component); });
}

/// max |error|/(1 + |y|).
double relative_size(const State& error, const State& y) {
  double greatest = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    greatest = std::max(greatest, std::abs(error[i]) / (1 + std::abs(y[i])));
  }
  return greatest;
}

}  // namespace

AdaptiveSteps::AdaptiveSteps(Slope slope, double tolerance)
    : slope_(std::move(slope)), tolerance_(tolerance) {}

void AdaptiveSteps::start(double x, const State& y) {
  x_ = x_before_ = x;
  y_ = y_before_ = y;
  slope_(y_, slope_at_y_, x_);
}

bool AdaptiveSteps::step(double limit) {
  if (length_ == 0) length_ = kFirst * (limit - x_);
  while (true) {
    const bool shortened = length_ >= limit - x_;
    const double length = shortened ? limit - x_ : length_;
    if (!(x_ + length > x_)) return false;
    const double wanted = length_;
    if (try_step(length)) {
      // What was shortened to meet the limit says little of what is possible.
      if (shortened) {
        x_ = limit;
        length_ = std::max(length_, wanted);
      }
      return true;
    }
  }
}

void AdaptiveSteps::go(const State& from, const State& slope, double x, double length, State& y,
                       State& end_slope, State& error) const {
  if (!is_implicit()) {
    DormandPrince method;
    method.do_step(std::cref(slope_), from, slope, x, y, end_slope, length, error);
    return;
  }
  implicit_step(slope_, from, slope, sensitivities_(from, slope, x, kDifference * length), x,
                length, y, error);
  slope_(y, end_slope, x + length);
}

bool AdaptiveSteps::try_step(double length) {
  State y, slope, error;
  go(y_, slope_at_y_, x_, length, y, slope, error);
  if (!is_finite(y) || !is_finite(slope) || !is_finite(error)) {
    length_ = length * kShrink;
    return false;
  }
  const double size = relative_size(error, y) / tolerance_;
  const double power = is_implicit() ? -0.25 : -0.2;
  length_ =
      length * (size > 0 ? std::clamp(kCaution * std::pow(size, power), kShrink, kGrow) : kGrow);
  // An implicit method comes down to a motion that it cannot resolve, as at a jump of torque.
  const bool resolved = !is_implicit() || length > kUnresolved * std::max(1.0, std::abs(x_));
  if (size > 1 && resolved) return false;
  x_before_ = x_;
  y_before_ = y_;
  slope_before_ = slope_at_y_;
  x_ += length;
  y_ = y;
  slope_at_y_ = slope;
  return true;
}

AdaptiveSteps::State AdaptiveSteps::at(double x) const {
  if (x == x_) return y_;
  State y, slope, error;
  go(y_before_, slope_before_, x_before_, x - x_before_, y, slope, error);
  return y;
}

}  // namespace cognate::machine
