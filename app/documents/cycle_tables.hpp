/// @file Limits over the full turn of the crank, and what they refer to, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::app {

/// Adds what is limited over the full turn to `[constraints]`.
void add_cycle_limits(const problems::Constraints& given, nlohmann::ordered_json& table);

/// Adds `drive`, `link`, `load` and `gravity` to the tables of a file, where a limit refers to
/// them.
void add_operation(const problems::Constraints& given, nlohmann::ordered_json& tables);

}  // namespace cognate::app
