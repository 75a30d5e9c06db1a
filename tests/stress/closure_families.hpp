/// @file Families of configurations that approach what is singular, to measure accuracy on.
#pragma once

#include <functional>
#include <random>
#include <string_view>
#include <vector>

#include "tests/stress/exact_closure.hpp"

namespace cognate::stress {

/// Configurations at a distance from the singular one: a relative amount named by `distance_is`,
/// one of `distances`; a single distance of 1 for families that approach nothing.
struct Family {
  std::string_view name;
  std::string_view distance_is;
  std::vector<double> distances;
  std::function<Configuration(double distance, std::mt19937_64&)> draw;
};

/// 10⁻ᵏ for k = first, first + ½, …, last.
std::vector<double> half_decades(int first, int last);

/// Random linkages; ratios of links; each link vanishing; limits of the crank; change points.
std::vector<Family> closure_families();

}  // namespace cognate::stress
