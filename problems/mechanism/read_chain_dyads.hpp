/// @file `[[dyad]]`: the class II Assur groups of a chain.
#pragma once

#include "problems/mechanism/read_chain.hpp"

namespace cognate::problems::reading {

/// Adds the dyad in `table` to `chain`: its bodies, its inner joint, and its outer joints as
/// further places of the points that it joins. With a fault `chain.names.incomplete` is set and
/// nothing is added.
void read_dyad(TableReader& table, Chain& chain);

}  // namespace cognate::problems::reading
