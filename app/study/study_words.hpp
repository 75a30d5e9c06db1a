/// @file How rows and studies came out, in the words of files.
#pragma once

#include <optional>
#include <string_view>

#include "problems/study/study_block.hpp"

namespace cognate::app {

/// "solved", "infeasible", "no-solution", "invalid", "filtered".
std::string_view run_status_name(problems::RunStatus status);

/// The status of that name, if there is one.
std::optional<problems::RunStatus> run_status(std::string_view name);

}  // namespace cognate::app
