/// @file The tolerances of a design on the terminal.
#pragma once

#include <string>

#include "app/console/screen.hpp"
#include "problems/tolerance/result.hpp"

namespace cognate::app {

/// The quantities with their worst cases, statistics and quantiles, what each dimension contributes
/// to the judged one, clearances and allocated tolerances.
std::string tolerance_table(const problems::ToleranceResult& result, const Screen& screen);

}  // namespace cognate::app
