/// @file Chains of which the file gives every dimension: the crank alone is found.
#pragma once

#include <optional>

#include "problems/chain/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Whether the file gives every dimension and assembly of `topology`.
bool is_given(const Topology& topology);

/// The mechanism of such a topology.
NamedMechanism given_mechanism(const Topology& topology);

/// Whether `problem` is of one such chain, which nothing else may change.
bool is_given(const ChainPathProblem& problem);

/// The design of such a problem, its crank where the traced point is nearest to the targets, in
/// order; empty where it cannot be assembled at all of them.
std::optional<Design> given_design(const ChainPathProblem& problem);

}  // namespace cognate::problems
