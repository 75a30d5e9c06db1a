/// @file `motor.train`: a gear train between motor and drive.
#pragma once

#include <filesystem>
#include <optional>

#include "problems/basics/length_unit.hpp"
#include "problems/machine/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Where a train is looked for, and the unit of its lengths where its tables give none.
struct TrainContext {
  const std::filesystem::path& folder;  ///< of the machine's file; empty: there is none
  std::optional<LengthUnit> length_unit{};
};

/// The train of `motor` with its shafts; empty where there is none, or with a fault where it cannot
/// be read, is no transmission between these shafts, or stands beside a ratio or an efficiency.
std::optional<MotorTrain> read_motor_train(TableReader& motor, const TrainContext& context);

}  // namespace cognate::problems::reading
