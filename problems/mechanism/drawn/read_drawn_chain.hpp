/// @file A chain that is given by its joints as drawn.
#pragma once

#include "problems/mechanism/read_chain.hpp"

namespace cognate::problems::reading {

/// The drive and the dyads of the joints in `document` or `mechanism` (`[mechanism]`), with
/// `Chain::drawn`. With a fault, `names.incomplete` is set.
Chain read_drawn_chain(TableReader& document, TableReader& mechanism);

}  // namespace cognate::problems::reading
