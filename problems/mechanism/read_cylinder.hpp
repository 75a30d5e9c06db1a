/// @file `[cylinder]`: a chain's drive by the length of a cylinder.
#pragma once

#include "problems/mechanism/read_chain.hpp"

namespace cognate::problems::reading {

/// The drive in `table`, into `chain`, with the rod as its body and the group of the cylinder and
/// its link as the first dyad.
void read_cylinder(TableReader& table, Chain& chain);

}  // namespace cognate::problems::reading
