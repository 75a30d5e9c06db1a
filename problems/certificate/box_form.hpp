/// @file Whether a quadratic of four variables is positive over [−1, 1]⁴, shown by intervals.
#pragma once

#include <array>

#include "problems/certificate/quad_interval.hpp"

namespace cognate::problems {

/// (1, t) M (1, t)ᵀ for t in [−1, 1]⁴, M symmetric.
using BoxForm = std::array<std::array<QuadInterval, 5>, 5>;

/// About the least value over the box, and multipliers λ of 1 − t_i² ≥ 0 that show it: with λ taken
/// from the constant and added to the diagonal the form has that least value anywhere.
struct FormMinimum {
  double value = 0;
  std::array<double, 4> multiplier{};
};

FormMinimum form_minimum(const BoxForm& form);

/// Whether the form exceeds `loss` all over the box: a form of all of R⁴ that is no greater within
/// the box, by `multiplier`, has positive pivots.
bool surely_exceeds(const BoxForm& form, const std::array<double, 4>& multiplier,
                    const QuadInterval& loss);

}  // namespace cognate::problems
