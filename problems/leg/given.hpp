/// @file Legs of which the file gives every dimension: where they stand is found.
#pragma once

#include <optional>

#include "problems/leg/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Whether `problem` is of one leg that the file gives whole.
bool is_given(const LegProblem& problem);

/// The design of such a problem, as it is. Its stance is that of the duty factor specified; where
/// the duty factor is to be greatest, it is the longest stance of the stride specified, of those
/// within the limits if there are such, and of the least duty factor where no stance has that
/// stride. Empty where the leg is not assembled over the whole turn or does not walk.
std::optional<Design> given_design(const LegProblem& problem);

}  // namespace cognate::problems
