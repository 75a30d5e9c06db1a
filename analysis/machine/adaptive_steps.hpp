/// @file Steps of an explicit Runge–Kutta method whose lengths follow from the required accuracy.
#pragma once

#include <array>
#include <functional>

namespace cognate::machine {

/// What an implicit step needs of dy/dx = f(y, x), where f depends on the first component of y
/// alone: its derivatives by that and by x.
template <class State>
struct Sensitivity {
  State by_first{}, by_x{};
};

/// A step of the stiffly accurate Rosenbrock method RODAS of order 4 with its error (Hairer &
/// Wanner, Solving Ordinary Differential Equations II, IV.7), whose linear systems are those of a
/// single equation here, the others being integrals.
template <class State, class Slope>
void implicit_step(Slope&& f, const State& y, const State& slope,
                   const Sensitivity<State>& sensitivity, double x, double length, State& end,
                   State& error) {
  constexpr double kGamma = 0.25;
  constexpr std::array<double, 6> kAt{0, 0.386, 0.21, 0.63, 1, 1};
  constexpr std::array<double, 6> kByX{0.25, -0.1043, 0.1035, -0.03620000000000023, 0, 0};
  constexpr std::array<std::array<double, 5>, 6> kA{
      {{},
       {1.544},
       {0.9466785280815826, 0.2557011698983284},
       {3.314825187068521, 2.896124015972201, 0.9986419139977817},
       {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
       {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}}};
  constexpr std::array<std::array<double, 5>, 6> kC{
      {{},
       {-5.6688},
       {-2.430093356833875, -0.2063599157091915},
       {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
       {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
       {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136,
        -6.058818238834054}}};
  const double diagonal = 1 / (kGamma * length);
  std::array<State, 6> u;
  State at, acting;
  for (std::size_t stage = 0; stage < u.size(); ++stage) {
    at = y;
    for (std::size_t k = 0; k < stage; ++k) {
      for (std::size_t i = 0; i < at.size(); ++i) at[i] += kA[stage][k] * u[k][i];
    }
    acting = slope;
    if (stage > 0) f(at, acting, x + kAt[stage] * length);
    for (std::size_t i = 0; i < at.size(); ++i) {
      acting[i] += kByX[stage] * length * sensitivity.by_x[i];
      for (std::size_t k = 0; k < stage; ++k) acting[i] += kC[stage][k] / length * u[k][i];
    }
    const double first = acting[0] / (diagonal - sensitivity.by_first[0]);
    for (std::size_t i = 1; i < at.size(); ++i) {
      u[stage][i] = (acting[i] + sensitivity.by_first[i] * first) / diagonal;
    }
    u[stage][0] = first;
  }
  error = u.back();
  for (std::size_t i = 0; i < at.size(); ++i) end[i] = at[i] + error[i];
}

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
