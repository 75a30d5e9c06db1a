/// @file A gear train of a file with its members by number.
#pragma once

#include <string>
#include <vector>

#include "analysis/train/planets.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems {

/// Names of all members: of gears in mesh, carriers and what clutches join, in the order of the
/// file.
std::vector<std::string> member_names(const GearTrainProblem& problem);

struct ResolvedTrain {
  std::vector<std::string> names;
  train::GearTrain train;
  std::vector<train::SizedMesh> sized;  ///< the meshes of `train` again
  std::vector<train::Planet> planets;
  std::vector<int> inputs;
  int output = train::kFrame;  ///< kFrame: none

  int number_of(const std::string& name) const;
};

/// `problem`, whose names must be those of members, in `state`; null: of a train without states.
ResolvedTrain resolved(const GearTrainProblem& problem, const TrainState* state);

/// The states of a gearbox; a null pointer alone where it has none.
std::vector<const TrainState*> states_of(const GearTrainProblem& problem);

}  // namespace cognate::problems
