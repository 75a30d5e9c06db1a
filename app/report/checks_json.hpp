/// @file The checks of a design's constraints as the pages have them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "problems/linkage/result.hpp"

namespace cognate::app {

/// A list of `{name, value, bound, satisfied}`; a bound is a number, a text, both ends, or the one
/// that there is as `{min}` or `{max}`.
nlohmann::ordered_json constraints_json(const std::vector<problems::ConstraintCheck>& checks);

}  // namespace cognate::app
