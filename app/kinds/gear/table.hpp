/// @file A gear, and the gear pairs found, as text for people.
#pragma once

#include <string>

#include "app/console/screen.hpp"
#include "problems/gear/result.hpp"

namespace cognate::app {

/// Every fact of the gear, and what makes it impossible.
std::string gear_table(const problems::GearProblem& problem, const problems::GearResult& result,
                       const Screen& screen);

/// A row for each pair; of one that was given, or is the only one, every fact.
std::string gear_pair_table(const problems::GearPairProblem& problem,
                            const problems::GearPairResult& result, const Screen& screen);

}  // namespace cognate::app
