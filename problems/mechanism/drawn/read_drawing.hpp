/// @file `[[joint]]` and `driven` of a chain: a mechanism by its joints, as it is drawn.
#pragma once

#include <optional>

#include "problems/mechanism/drawn/drawing.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Whether a chain is given by its joints.
bool is_drawn(const TableReader& document, const TableReader& mechanism);

/// The joints in `document` or `mechanism` (`[mechanism]`); empty, with a fault, where a table is
/// wrong or a joint can be none of a mechanism: whatever else is asked of it.
std::optional<Drawing> read_drawing(TableReader& document, TableReader& mechanism);

}  // namespace cognate::problems::reading
