/// @file What a file about a gear train specifies. Speeds are in rad/s, torques in N m.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"

namespace cognate::problems {

/// `type` of a mesh: which teeth, and whether both gears turn alike in the frame of their carrier.
enum class MeshType { external, internal, bevel, bevel_alike };

/// `[[mesh]]`. Members are known by their names.
struct TrainMesh {
  std::array<std::string, 2> gears;
  std::array<int, 2> teeth{};
  MeshType type = MeshType::external;
  double efficiency = 1;
  std::optional<double> module{};  ///< for distances; 1 where no mesh has one
};

/// `[[planet]]`: its axis goes round with the carrier.
struct TrainPlanet {
  std::string name;
  std::string carrier;
  int count = 1;       ///< equal ones, equally spaced
  double inertia = 0;  ///< of each, about its own axis
  double mass = 0;     ///< of each
};

/// `[[shaft]]`: what a member has in addition to its gears.
struct TrainShaft {
  std::string name;
  double inertia = 0;
};

/// `[[input]]`.
struct TrainInput {
  std::string member;
  double speed = 1;
  std::optional<double> torque{};
};

/// `[output]`.
struct TrainOutput {
  std::string member;
  std::optional<double> torque{};  ///< from outside, that of a load against the motion
};

/// `[[brake]]`: holds a member to the frame where it is engaged.
struct TrainBrake {
  std::string name;
  std::string holds;
};

/// `[[clutch]]`: makes two members turn as one where it is engaged.
struct TrainClutch {
  std::string name;
  std::array<std::string, 2> joins;
};

/// `[[state]]` of a gearbox, a row of its table: the brakes and clutches that are engaged.
struct TrainState {
  std::string name;
  std::vector<std::string> engaged;
};

/// `target.train`: what is sought.
enum class TrainType { compound, planetary };

/// `target.objective`, among trains within the tolerance.
enum class TrainObjective { error, size };

/// Members of a simple planetary train.
enum class PlanetaryMember { sun, ring, carrier };

/// `[target]`, `[bounds]` and `[solve]` of a train that is to be found.
struct TrainTarget {
  TrainType train = TrainType::compound;
  double ratio = 1;  ///< input speed over output speed; of compound trains its magnitude
  double ratio_tolerance = 1e-3;  ///< relative
  TrainObjective objective = TrainObjective::error;
  std::array<int, 2> teeth{17, 100};  ///< of gears; of a planetary train those of sun and planets
  std::array<int, 2> ring_teeth{40, 200};
  std::array<int, 2> pairs{1, 3};  ///< of a compound train
  bool coaxial = false;            ///< of two pairs: both have one sum of teeth
  std::array<int, 2> planets{3, 3};
  PlanetaryMember input = PlanetaryMember::sun, output = PlanetaryMember::carrier;
  int designs = 3;
};

/// `kind = "gear-train"`: one that is given by its meshes, or one that is found for a ratio.
struct GearTrainProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  std::vector<TrainMesh> meshes;
  std::vector<TrainPlanet> planets;
  std::vector<TrainShaft> shafts;
  std::vector<std::string> fixed;
  std::vector<TrainBrake> brakes;
  std::vector<TrainClutch> clutches;
  std::vector<TrainInput> inputs;
  std::optional<TrainOutput> output;
  std::vector<TrainState> states;
  std::optional<TrainTarget> target;  ///< then there is nothing of the above
};

template <>
struct KindTraits<GearTrainProblem> {
  static constexpr std::string_view kWord = "gear-train";
  static GearTrainProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const GearTrainProblem& problem);
  static tl::expected<GearTrainProblem, std::vector<std::string>> checked(
      const GearTrainProblem& problem);
};

template <>
std::span<const Named<MeshType>> names<MeshType>();
template <>
std::span<const Named<TrainType>> names<TrainType>();
template <>
std::span<const Named<TrainObjective>> names<TrainObjective>();
template <>
std::span<const Named<PlanetaryMember>> names<PlanetaryMember>();

}  // namespace cognate::problems
