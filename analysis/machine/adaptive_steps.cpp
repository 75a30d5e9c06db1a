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

bool AdaptiveSteps::try_step(double length) {
  State y, slope, error;
  DormandPrince method;
  method.do_step(std::ref(slope_), y_, slope_at_y_, x_, y, slope, length, error);
  if (!is_finite(y) || !is_finite(slope) || !is_finite(error)) {
    length_ = length * kShrink;
    return false;
  }
  const double size = relative_size(error, y) / tolerance_;
  length_ =
      length * (size > 0 ? std::clamp(kCaution * std::pow(size, -0.2), kShrink, kGrow) : kGrow);
  if (size > 1) return false;
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
  DormandPrince method;
  method.do_step(std::cref(slope_), y_before_, slope_before_, x_before_, y, slope, x - x_before_,
                 error);
  return y;
}

}  // namespace cognate::machine
