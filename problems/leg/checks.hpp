/// @file Where the limits of a leg are to be asked, and by how much a leg misses them.
#pragma once

#include "problems/leg/model.hpp"

namespace cognate::problems {

/// The extremes of a leg, between samples too. `violation`: the most by which a limit is missed, as
/// constraints are scaled in the model, infinite where the leg cannot be assembled all along.
LegChecks leg_checks(const LegSpace& space, const LegDesign& design, double& violation);

/// Half the extent of the foot in stance across the ground.
double half_band(const LegSpace& space, const LegDesign& design);

}  // namespace cognate::problems
