/// @file Zeros of a function of the drive coordinate, refined to rounding.
#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"

namespace cognate {

/// The neighbouring numbers between which `f` changes its sign, from a < b where f has opposite
/// signs `at_a` and `at_b`, neither zero (Alefeld, Potra & Shi 1995, algorithm 748); or numbers
/// within `relative` of their size, or those that `evaluations` of f lead to.
template <class Function>
std::pair<double, double> bracket_zero(Function&& f, double a, double at_a, double b, double at_b,
                                       double relative = 2 * kEpsilon,
                                       std::uintmax_t evaluations = 200) {
  using boost::math::policies::domain_error;
  using boost::math::policies::errno_on_error;
  using boost::math::policies::evaluation_error;
  const boost::math::policies::policy<domain_error<errno_on_error>,
                                      evaluation_error<errno_on_error>>
      quiet;
  const auto is_close = [=](double low, double high) {
    return high - low <= relative * std::max(std::abs(low), std::abs(high));
  };
  return boost::math::tools::toms748_solve(f, a, b, at_a, at_b, is_close, evaluations, quiet);
}

/// The point of `bracket` at which |f| is the smaller.
template <class Function>
double better_end(Function&& f, const std::pair<double, double>& bracket) {
  return std::abs(f(bracket.first)) <= std::abs(f(bracket.second)) ? bracket.first : bracket.second;
}

/// `cells` + 1 places from `from` to `to`, crowded towards the ends as the zeros of Chebyshev's
/// polynomials are: the motion next to a dead point goes with the root of the distance from it, and
/// is smooth over such places.
inline std::vector<double> crowded(double from, double to, int cells) {
  std::vector<double> places(static_cast<std::size_t>(cells) + 1);
  for (int i = 0; i <= cells; ++i) {
    const double half = std::sin(kPi * i / (2 * cells));
    places[static_cast<std::size_t>(i)] = from + (to - from) * (half * half);
  }
  places.back() = to;
  return places;
}

}  // namespace cognate
