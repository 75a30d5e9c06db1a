/// @file What the page of a gear train draws.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/train/result.hpp"

namespace cognate::app {

/// `designs`, each with `members` (name, role, speeds, torque, power, inertia), `metrics`,
/// `constraints` and `circles`: pitch circles with the member that they turn with, radius, place,
/// and where the place goes round, the member that carries it; null where the train has no picture.
nlohmann::ordered_json train_report_data(const problems::GearTrainResult& result);

}  // namespace cognate::app
