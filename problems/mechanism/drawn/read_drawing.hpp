/// @file `[[joint]]` and `driven` of a chain: a mechanism by its joints, as it is drawn.
#pragma once

#include "problems/mechanism/drawn/drawing.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Whether a chain is given by its joints.
bool is_drawn(const TableReader& document, const TableReader& mechanism);

/// The joints in `document` or `mechanism` (`[mechanism]`), those that are faulted among them.
Drawing read_drawing(TableReader& document, TableReader& mechanism);

}  // namespace cognate::problems::reading
