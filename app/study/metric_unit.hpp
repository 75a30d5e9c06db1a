/// @file The unit of a number that a result names.
#pragma once

#include <string>
#include <string_view>

namespace cognate::app {

/// The unit of the metric or column `name`, "deg", as `cognate list --metrics` has it or as the
/// name itself says ("..._deg", "..._N"); empty where it has none or it is not known.
std::string metric_unit(std::string_view name);

}  // namespace cognate::app
