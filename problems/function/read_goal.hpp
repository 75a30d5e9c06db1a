/// @file How well a function generator shall follow its target: exactly at precision points, or
/// with the least error at samples.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Samples where the file says nothing: enough to see each wave of an error with five zeros.
inline constexpr int kDefaultSamples = 61;

/// Reads `precision_points`, `at`, `multiplicity`, `objective`, `method`, `samples` and
/// `sample_at`, each from `[target]` or `[solve]`, and `derivatives` of `[target]`, into `problem`,
/// whose type and target have been read.
void read_function_goal(TableReader& target, TableReader& solve, FunctionProblem& problem);

/// Makes the keys known where the target has faults of its own.
void know_function_goal(TableReader& target, TableReader& solve);

}  // namespace cognate::problems::reading
