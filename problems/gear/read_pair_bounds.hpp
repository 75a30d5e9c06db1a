/// @file Within which a gear pair is looked for.
#pragma once

#include "problems/gear/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// `[bounds]` of a gear pair whose `[mechanism]` has been read: what of that is left out must be
/// bounded where it has no bounds of its own, what is given must not be.
void read_gear_pair_bounds(TableReader& mechanism, TableReader& bounds, GearPairProblem& problem);

}  // namespace cognate::problems::reading
