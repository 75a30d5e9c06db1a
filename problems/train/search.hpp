/// @file Gear trains of a given ratio.
#pragma once

#include "problems/train/result.hpp"

namespace cognate::problems {

/// Adds the best trains for the target of `problem` to `result`, those within the tolerance; where
/// there is none, the nearest. Ends early at `deadline`.
void find_trains(const GearTrainProblem& problem, const Deadline& deadline,
                 GearTrainResult& result);

}  // namespace cognate::problems
