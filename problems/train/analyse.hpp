/// @file A given gear train in one state: speeds, torques, efficiency, inertia, planets.
#pragma once

#include <string>

#include "problems/train/result.hpp"

namespace cognate::problems {

/// `problem` is valid and has no target; `state` is null where it has none.
GearTrainDesign analysed_train(const GearTrainProblem& problem, const TrainState* state,
                               const std::string& origin);

}  // namespace cognate::problems
