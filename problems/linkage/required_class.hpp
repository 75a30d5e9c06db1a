/// @file Whether a four-bar is of the class that a file demands.
#pragma once

#include "analysis/linkage/mobility.hpp"
#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// Whether a four-bar reported as `found` satisfies `required`: its own class, `grashof` any but a
/// triple rocker, `non_grashof` that alone. A change point has the class that `mobility_class`
/// gives it and no other.
bool is_of_class(MobilityClass found, RequiredClass required);

}  // namespace cognate::problems
