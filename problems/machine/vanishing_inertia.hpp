/// @file Where a machine has no inertia.
#pragma once

#include <optional>

#include "analysis/machine/machine.hpp"

namespace cognate::problems {

/// φ in [0, 2π) at which the inertia of `machine` vanishes, as where all that has mass stands
/// still: it then falls to the square of rounding of what it is beside that place. Places where it
/// has no value are passed over. Empty where there is none.
std::optional<double> vanishing_inertia(const machine::Machine& machine);

}  // namespace cognate::problems
