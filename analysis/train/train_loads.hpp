/// @file Torques and powers in a gear train that turns steadily.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/train/gear_train.hpp"

namespace cognate::train {

/// What acts in the train. Torques are positive in the sense of positive speeds; those from outside
/// drive where torque and speed have one sign.
struct TrainLoads {
  std::vector<double> external;  ///< on each member from outside, reactions of fixed ones included
  std::vector<double> clutch;    ///< on the first of each joined pair, from the second
  std::vector<double> torque;    ///< of each mesh on its first gear
  std::vector<double> power;     ///< through each mesh in its carrier's frame, from first to second
  std::vector<double> loss;      ///< of each mesh, not negative
};

struct KnownTorque {
  int member = 0;
  double torque = 0;
};

/// The balance of torques on every member: each mesh passes the power that enters it in the frame
/// of its carrier less its loss (Müller, Epicyclic Drive Trains), and the sense in which it
/// does so follows from the solution itself. `known` acts from outside, and so does what is sought
/// on `unknown`; together with the fixed members these must determine the train's speeds.
///
/// Empty where no sense of the power through the meshes agrees with the torques that follow from it
/// (the train is self-locking), or where the conditions are redundant.
std::optional<TrainLoads> loads_of(const GearTrain& train, const std::vector<double>& speeds,
                                   const std::vector<KnownTorque>& known,
                                   const std::vector<int>& unknown);

}  // namespace cognate::train
