/// @file Numbers that are only drawn.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace cognate::app {

/// `x` to the digits of a drawing; null where it is not a number.
nlohmann::ordered_json drawn(double x);

}  // namespace cognate::app
