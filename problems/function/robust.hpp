/// @file Function generators that mind their tolerances least, as a task of the search for these.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/function/search.hpp"
#include "problems/search/robust.hpp"

namespace cognate::problems {

/// The design of a generator; empty where it breaks a constraint.
using VerifiedFunction = std::function<std::optional<Design>(const FunctionGenerator& generator)>;

/// The search from minima of `problem`, which with `wanted` must outlive the task. Errors are in
/// degrees, the greatest over the samples. Without a start where no length has a tolerance.
RobustTask robust_function_task(const FunctionProblem& problem, const FunctionSamples& wanted,
                                const std::vector<FunctionDesign>& minima,
                                const VerifiedFunction& verified);

}  // namespace cognate::problems
