/// @file A step of an implicit method, for machines that are heavily damped.
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

}  // namespace cognate::machine
