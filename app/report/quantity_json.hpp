/// @file Facts of a result as the pages have them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "problems/basics/quantity.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// A list of `{name, value, bound, satisfied}`; a bound is a number, a text, both ends, or the one
/// that there is as `{min}` or `{max}`.
nlohmann::ordered_json constraints_json(const std::vector<problems::ConstraintCheck>& checks);

/// A list of `{name, value}`; the value is null where it is not finite.
nlohmann::ordered_json quantities_json(const std::vector<problems::Quantity>& quantities);

}  // namespace cognate::app
