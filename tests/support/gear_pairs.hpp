/// @file Spur pairs of the standard rack, and what is reported of them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/gear/result.hpp"

namespace cognate::test {

inline constexpr double kAlpha = kPi / 9;

inline problems::GearPairProblem spur_problem(problems::GearObjective objective) {
  problems::GearPairProblem problem;
  problem.rack.pressure_angle = kAlpha;
  problem.objective = objective;
  problem.constraints.contact_ratio_min = 1.2;
  problem.constraints.tip_thickness_min = 0.25;
  problem.profile_shift_bounds = {-0.5, 1};
  return problem;
}

inline problems::GearPairProblem given_pair(int z1, int z2, double module, double centre_distance) {
  problems::GearPairProblem problem;
  problem.teeth = {z1, z2};
  problem.module = module;
  problem.profile_shift = {0, 0};
  problem.centre_distance = centre_distance;
  return problem;
}

inline double quantity(const std::vector<problems::Quantity>& quantities, const std::string& name) {
  for (const problems::Quantity& each : quantities) {
    if (each.name == name) return std::get<double>(each.value);
  }
  ADD_FAILURE() << "no fact " << name;
  return NAN;
}

}  // namespace cognate::test
