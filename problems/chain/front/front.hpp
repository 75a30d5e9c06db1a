/// @file Fronts of chains: the error weighed against another measure.
#pragma once

#include <functional>

#include "problems/chain/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Designs of least error of a problem that weighs it against nothing, from `run.known` too.
using LeastError =
    std::function<Result(const ChainPathProblem& problem, const Run& run, const Deadline&)>;

/// Designs of which none is as good as another in both the error and `problem.against`, best error
/// first, and the levels of both as a family "Pareto front". Where the measure is a number of
/// links, the best design of each; else a row of bounds on it, each searched from the designs
/// beside it too.
Result chain_front(const ChainPathProblem& problem, const Run& run, const Deadline& deadline,
                   const LeastError& solve);

}  // namespace cognate::problems
