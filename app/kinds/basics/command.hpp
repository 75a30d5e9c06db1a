/// @file The commands among which a kind of problem decides.
#pragma once

namespace cognate::app {

/// The commands that compute the problem of a file.
enum class Command { solve, analyze };

}  // namespace cognate::app
