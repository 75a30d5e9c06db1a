#include "problems/train/resolve.hpp"

#include <algorithm>

namespace cognate::problems {
namespace {

const TrainPlanet* planet_named(const GearTrainProblem& problem, const std::string& name) {
  const auto found = std::ranges::find(problem.planets, name, &TrainPlanet::name);
  return found == problem.planets.end() ? nullptr : &*found;
}

/// The carrier of the planet in `mesh`; kFrame where neither gear is one.
int carrier_of(const GearTrainProblem& problem, const TrainMesh& mesh,
               const ResolvedTrain& resolved) {
  for (const auto& gear : mesh.gears) {
    if (const auto* planet = planet_named(problem, gear))
      return resolved.number_of(planet->carrier);
  }
  return train::kFrame;
}

bool is_bevel(MeshType type) {
  return type == MeshType::bevel || type == MeshType::bevel_alike;
}

train::SizedMesh sized_mesh(const GearTrainProblem& problem, const TrainMesh& mesh,
                            const ResolvedTrain& resolved) {
  train::Mesh made{.gears = {resolved.number_of(mesh.gears[0]), resolved.number_of(mesh.gears[1])},
                   .teeth = mesh.teeth,
                   .carrier = carrier_of(problem, mesh, resolved),
                   .sense = -1,
                   .efficiency = mesh.efficiency};
  if (mesh.type == MeshType::internal || mesh.type == MeshType::bevel_alike) made.sense = 1;
  return {made, mesh.module.value_or(1), is_bevel(mesh.type)};
}

void engage(const GearTrainProblem& problem, const TrainState& state, ResolvedTrain& resolved) {
  for (const std::string& name : state.engaged) {
    const auto brake = std::ranges::find(problem.brakes, name, &TrainBrake::name);
    if (brake != problem.brakes.end()) {
      resolved.train.fixed.push_back(resolved.number_of(brake->holds));
    }
    const auto clutch = std::ranges::find(problem.clutches, name, &TrainClutch::name);
    if (clutch == problem.clutches.end()) continue;
    resolved.train.joined.push_back(
        {resolved.number_of(clutch->joins[0]), resolved.number_of(clutch->joins[1])});
  }
}

}  // namespace

std::vector<std::string> member_names(const GearTrainProblem& problem) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const auto& mesh : problem.meshes) {
    for (const auto& gear : mesh.gears) {
      add(gear);
      if (const auto* planet = planet_named(problem, gear)) add(planet->carrier);
    }
  }
  for (const auto& clutch : problem.clutches) {
    for (const auto& name : clutch.joins) add(name);
  }
  return names;
}

int ResolvedTrain::number_of(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? train::kFrame : static_cast<int>(found - names.begin());
}

ResolvedTrain resolved(const GearTrainProblem& problem, const TrainState* state) {
  ResolvedTrain made;
  made.names = member_names(problem);
  made.train.members = static_cast<int>(made.names.size());
  for (const auto& mesh : problem.meshes) {
    made.sized.push_back(sized_mesh(problem, mesh, made));
    made.train.meshes.push_back(made.sized.back().mesh);
  }
  for (const auto& planet : problem.planets) {
    made.planets.push_back(
        {made.number_of(planet.name), made.number_of(planet.carrier), planet.count});
  }
  for (const auto& name : problem.fixed) made.train.fixed.push_back(made.number_of(name));
  if (state) engage(problem, *state, made);
  for (const auto& input : problem.inputs) made.inputs.push_back(made.number_of(input.member));
  if (problem.output) made.output = made.number_of(problem.output->member);
  return made;
}

std::vector<const TrainState*> states_of(const GearTrainProblem& problem) {
  if (problem.states.empty()) return {nullptr};
  std::vector<const TrainState*> all;
  for (const auto& state : problem.states) all.push_back(&state);
  return all;
}

}  // namespace cognate::problems
