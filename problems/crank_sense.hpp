/// @file In which sense a crank meets points one after another.
#pragma once

#include <span>

#include "problems/problem.hpp"
#include "problems/result.hpp"

namespace cognate::problems {

/// Whether a crank that meets the points at `crank_angles` (from the x axis) turns in the sense
/// asked for: that in which it turns less, going one way only.
ConstraintCheck check_sense(CrankSense wanted, std::span<const double> crank_angles);

}  // namespace cognate::problems
