/// @file Which points of a chain are on one body.
#pragma once

#include <vector>

#include "synthesis/chain/chain.hpp"

namespace cognate::synthesis {

/// The bodies of `chain` as lists of lines, ascending: the frame with all pivots and guides, the
/// crank, then those of the dyads. The joint of a dyad whose two points are on one body is on that
/// body too: it makes a rigid triangle.
std::vector<std::vector<int>> bodies(const Chain& chain);

/// The lines of the dyads whose joints move: all but rigid triangles.
std::vector<int> joints(const Chain& chain);

}  // namespace cognate::synthesis
