/// @file The commands that kinds tell apart.
#pragma once

namespace cognate::app {

/// The commands that compute what a file asks for.
enum class Command { solve, analyze };

}  // namespace cognate::app
