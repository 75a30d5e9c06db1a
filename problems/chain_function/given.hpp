/// @file Function generators that are chains of which the file gives every dimension: where the
/// crank starts is found.
#pragma once

#include <optional>

#include "problems/chain_function/problem.hpp"
#include "problems/chain_function/space.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Whether `problem` is of one chain that the file gives whole.
bool is_given(const ChainFunctionProblem& problem);

/// The design of such a problem, its crank started where the error is least, within the limits of
/// the transmission angle if it can be; empty where it cannot generate the whole function from
/// anywhere.
std::optional<Design> given_design(const ChainFunctionProblem& problem,
                                   const FunctionSamples& wanted);

}  // namespace cognate::problems
