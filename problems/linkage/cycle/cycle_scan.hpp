/// @file The least value of a function of the crank's angle over a turn, on a dense table, refined.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"

namespace cognate::problems {

/// Angles in equal steps from `begin`. Where that is the frame's direction, none of the peaks is
/// missed that accelerations and torques have near a change point, too narrow to be met by chance.
struct CycleScan {
  static constexpr int kAngles = 720;
  static constexpr double kStep = kTurn / kAngles;
  using Values = std::array<double, kAngles>;

  double begin = 0;

  double angle(int k) const { return begin + kStep * k; }

  template <class Function>
  Values table(const Function& function) const {
    Values values{};
    for (int k = 0; k < kAngles; ++k) values.at(static_cast<std::size_t>(k)) = function(angle(k));
    return values;
  }

  /// The least value of `function`, whose values at the angles are given; −∞ where it has none at
  /// some angle.
  template <class Function>
  double least(const Values& values, const Function& function) const {
    if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
      return -kInfinity;
    }
    const auto value = [&](int k) {
      return values.at(static_cast<std::size_t>((k + kAngles) % kAngles));
    };
    double least = kInfinity;
    for (const int k : minima(values)) {
      const double refined = least_between(function, angle(k - 1), angle(k + 1));
      least = std::min({least, value(k), refined});
    }
    return least;
  }

  template <class Function>
  double least(const Function& function) const {
    return least(table(function), function);
  }

 private:
  /// By the golden section, between two angles that enclose one minimum: at a kink as sharp as
  /// where the function is smooth.
  template <class Function>
  static double least_between(const Function& function, double from, double to) {
    constexpr int kSteps = 64;
    const auto found = golden_section(function, from, to, kSteps);
    const bool known = std::isfinite(found.at_low) && std::isfinite(found.at_high);
    return known ? found.least() : -std::numeric_limits<double>::infinity();
  }

  /// Least first. What is constant but for rounding has hundreds.
  static std::vector<int> minima(const Values& values) {
    constexpr std::size_t kMostRefined = 24;
    const auto value = [&](int k) {
      return values.at(static_cast<std::size_t>((k + kAngles) % kAngles));
    };
    std::vector<int> all;
    for (int k = 0; k < kAngles; ++k) {
      if (value(k) <= value(k - 1) && value(k) <= value(k + 1)) all.push_back(k);
    }
    std::ranges::sort(all, {}, value);
    if (all.size() > kMostRefined) all.resize(kMostRefined);
    return all;
  }
};

}  // namespace cognate::problems
