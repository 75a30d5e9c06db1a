/// @file Gears for the tests of their report page, as Cognate evaluates them.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "problems/gear/problem.hpp"

namespace cognate::problems {

struct SampleGear {
  std::string name;
  std::variant<GearProblem, GearPairProblem> problem;
};

/// A gear of 35 teeth and one of 9 that is undercut; pairs: 20 to 80 teeth, the same too far apart
/// (contact ratio 0.765) and with teeth that overlap, helical gears, bevel gears and a worm.
std::vector<SampleGear> sample_gears();

}  // namespace cognate::problems
