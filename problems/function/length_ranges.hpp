/// @file Between which limits the lengths of a function generator are sought.
#pragma once

#include <array>

#include "problems/function/problem.hpp"
#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// Limits of the lengths of a function problem, in the order crank, coupler, rocker, frame; a
/// length that the file fixes has both ends there. Where the file has no bound a length is between
/// 1/100 of the least and 100 times the greatest fixed one (further where `link_ratio_max` or the
/// other bounds say so): angles alone do not keep a linkage from growing without end.
std::array<Range, 4> length_ranges(const FunctionProblem& problem);

}  // namespace cognate::problems
