#include "problems/train/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<MeshType> kMeshTypes[] = {{"external", MeshType::external},
                                          {"internal", MeshType::internal},
                                          {"bevel", MeshType::bevel},
                                          {"bevel-alike", MeshType::bevel_alike}};
constexpr Named<TrainType> kTrainTypes[] = {{"compound", TrainType::compound},
                                            {"planetary", TrainType::planetary}};
constexpr Named<TrainObjective> kTrainObjectives[] = {{"error", TrainObjective::error},
                                                      {"size", TrainObjective::size}};
constexpr Named<PlanetaryMember> kPlanetaryMembers[] = {{"sun", PlanetaryMember::sun},
                                                        {"ring", PlanetaryMember::ring},
                                                        {"carrier", PlanetaryMember::carrier}};

}  // namespace

template <>
std::span<const Named<MeshType>> names<MeshType>() {
  return kMeshTypes;
}

template <>
std::span<const Named<TrainType>> names<TrainType>() {
  return kTrainTypes;
}

template <>
std::span<const Named<TrainObjective>> names<TrainObjective>() {
  return kTrainObjectives;
}

template <>
std::span<const Named<PlanetaryMember>> names<PlanetaryMember>() {
  return kPlanetaryMembers;
}

}  // namespace cognate::problems
