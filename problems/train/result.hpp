/// @file What analysing or finding a gear train gives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems {

/// What a member of a train does.
struct TrainMember {
  std::string name;
  std::string role;         ///< "shaft", "carrier" or "planet"
  std::string speed_exact;  ///< as multiple of the speed of a single input: "-72/35"; else empty
  double speed = 0;         ///< rad/s
  std::optional<double> relative_speed;       ///< of a planet, to its carrier
  std::optional<double> torque;               ///< from outside, N m
  std::optional<double> power;                ///< by it, W
  std::optional<double> equivalent_inertia;   ///< of the whole train at this member, kg m²
  std::optional<double> orbit_radius;         ///< of a planet
  std::optional<double> neighbour_clearance;  ///< of a planet
};

/// What goes through a mesh, from its first gear to its second in the frame of their carrier.
struct TrainMeshLoad {
  std::optional<double> torque;       ///< on the first gear, N m
  std::optional<double> power, loss;  ///< W
  double centre_distance = 0;
};

/// A train, or one state of a gearbox.
struct GearTrainDesign {
  GearTrainProblem settled;  ///< the train, without what was sought
  std::string state;         ///< empty of a train without states
  std::vector<Quantity> metrics;
  std::vector<TrainMember> members;
  std::vector<TrainMeshLoad> meshes;  ///< in the order of the file
  std::vector<ConstraintCheck> constraints;
  std::string origin;
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

struct GearTrainResult {
  Status status = Status::no_solution;
  std::vector<GearTrainDesign> designs;  ///< states in the order of the file; trains best first
  std::vector<Quantity> quantities;      ///< of the search
  Work work;
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// The trains for `problem`; of one that is given, what it does.
GearTrainResult solve(const GearTrainProblem& problem, const Run& run);

}  // namespace cognate::problems
