/// @file The version of the program.
#pragma once

#include <string_view>

namespace cognate::app {

/// The project's version, "0.1.0".
std::string_view version();

}  // namespace cognate::app
