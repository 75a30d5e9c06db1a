/// @file Tables of a result as the text of a problem file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace cognate::app {

/// The TOML that holds what `tables`, an object, holds, a section for each table in it; null is
/// left out. Numbers keep their value to the last digit.
std::string toml_text(const nlohmann::ordered_json& tables);

}  // namespace cognate::app
