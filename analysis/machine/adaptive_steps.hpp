/// @file Steps of an explicit Runge–Kutta method whose lengths follow from the required accuracy.
#pragma once

#include <array>
#include <functional>

#include "analysis/machine/implicit_step.hpp"

namespace cognate::machine {

/// Integrates dy/dx = f(y, x) forward by Dormand and Prince's method of order 5 (Boost.Odeint), or
/// an implicit one of order 4, step by step. The error of a step is at most `tolerance` (1 + |y|)
/// in each component: scale them to about 1. Allocates nothing after the beginning.
///
/// Where f is not a number the step is shortened; so integration comes up to the border of where f
/// is defined, and fails there.
class AdaptiveSteps {
 public:
  using State = std::array<double, 5>;
  using Slope = std::function<void(const State& y, State& slope, double x)>;

  /// The derivatives of f where it is `slope`, differences by x with this step.
  using Sensitivities =
      std::function<Sensitivity<State>(const State& y, const State& slope, double x, double step)>;

  AdaptiveSteps(Slope slope, double tolerance);

  /// From now on by an implicit method, for which f may depend on the first component alone; with
  /// no function by the explicit one again.
  void make_implicit(Sensitivities sensitivities) { sensitivities_ = std::move(sensitivities); }
  bool is_implicit() const { return static_cast<bool>(sensitivities_); }

  /// Begins, or goes on, at another state, with steps as long as before.
  void start(double x, const State& y);

  /// Takes a step, at most to `limit` > x; false where none is possible.
  bool step(double limit);

  double x() const { return x_; }
  const State& y() const { return y_; }
  const State& slope() const { return slope_at_y_; }

  /// Where the last step began.
  double x_before() const { return x_before_; }
  const State& y_before() const { return y_before_; }

  /// The state at a place within the last step, by a single step from its beginning, and so as
  /// exact as its end.
  State at(double x) const;

 private:
  bool try_step(double length);
  void go(const State& from, const State& slope, double x, double length, State& y,
          State& end_slope, State& error) const;

  Slope slope_;
  Sensitivities sensitivities_;
  double tolerance_;
  double length_ = 0;  ///< of the next step; 0: not known yet
  double x_ = 0, x_before_ = 0;
  State y_{}, y_before_{}, slope_at_y_{}, slope_before_{};
};

}  // namespace cognate::machine
