/// @file The four-bar that a study varies.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "problems/study/study.hpp"

namespace cognate::app {

/// Where the base file analyses a four-bar: its dimensions by their keys in the file, each a number
/// or, where it is varied, {"variable": index}; and under "start" where the drive starts, in
/// radians. Empty for any other base.
std::optional<nlohmann::ordered_json> study_linkage(const problems::Study& study);

}  // namespace cognate::app
