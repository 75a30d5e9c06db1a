/// @file Mechanisms with dwells of which the file gives every dimension: where the dwells begin is
/// found.
#pragma once

#include <optional>

#include "problems/dwell/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Whether `problem` is of one mechanism that the file gives whole.
bool is_given(const DwellProblem& problem);

/// The design of such a problem, its dwells where the greatest half band is least, one after the
/// other within a turn; empty where it is not assembled over the whole turn.
std::optional<Design> given_design(const DwellProblem& problem);

}  // namespace cognate::problems
