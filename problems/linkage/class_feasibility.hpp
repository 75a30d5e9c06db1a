/// @file Whether any linkage within given limits of length is of a wanted class.
#pragma once

#include <array>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems::reading {

/// The limits of crank, coupler, rocker and frame, closed; a lower limit of 0 stands for any
/// positive length, an upper one may be infinite. A given length has equal limits.
using LengthLimits = std::array<Range, 4>;

/// Whether some four lengths within `limits` can be assembled and are of class `wanted`, change
/// points having the class that `mobility_class` gives them. Exact: the
/// inequalities of Grashof are linear, and their extreme over a box has a closed form.
bool class_is_possible(const LengthLimits& limits, RequiredClass wanted);

}  // namespace cognate::problems::reading
