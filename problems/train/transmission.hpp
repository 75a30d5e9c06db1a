/// @file What a gear train passes from one of its shafts to another.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/train/train_loads.hpp"
#include "problems/train/resolve.hpp"

namespace cognate::problems {

/// The loads for a torque of 1 that drives one shaft against a load on another, and the efficiency
/// of the power in both senses; 0 where the train is self-locking.
struct UnitLoads {
  std::optional<train::TrainLoads> forward;  ///< those of a driven input
  double efficiency = 0;
  double reverse_efficiency = 0;
};

/// `speeds` of every member, neither that of `input` nor that of `output` 0.
UnitLoads unit_loads(const train::GearTrain& train, const std::vector<double>& speeds, int input,
                     int output);

/// Twice the kinetic energy of shafts and planets in J, `resolved` being `problem` and `speeds`
/// those of its members in rad/s.
double doubled_energy(const GearTrainProblem& problem, const ResolvedTrain& resolved,
                      const std::vector<double>& speeds);

/// Shafts of a train by their names, empty where its file has no more than one to choose from:
/// then its only `[[input]]` and its `[output]`. `state`: that of a gearbox.
struct TransmissionShafts {
  std::optional<std::string> input, output, state;
};

/// Ratio and efficiency between two shafts of a train, and its inertia.
struct Transmission {
  train::Fraction ratio;          ///< input speed over output speed, negative where they differ
  double efficiency = 1;          ///< of power from the input to the output, greater than 0
  double reverse_efficiency = 1;  ///< of power from output to input; 0: self-locking
  double output_inertia = 0;      ///< of the train, equivalent at the output, kg m²
};

/// What keeps a train from being a transmission: the word of the member of TransmissionShafts
/// that is at fault, else "train", and what is wrong with it, as messages go on after its name.
struct TransmissionFault {
  std::string_view key;
  std::string message;
};

/// Of `problem`, a valid train, between `shafts`. A fault where a name is unknown or missing, and
/// where the train is to be found yet, does not have one degree of freedom, is locked, shares its
/// load among redundant members, or cannot be driven at the input for losses.
tl::expected<Transmission, TransmissionFault> transmission(const GearTrainProblem& problem,
                                                           const TransmissionShafts& shafts);

}  // namespace cognate::problems
