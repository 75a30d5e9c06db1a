/// @file Whether joints make a mechanism of mobility one, of a drive and dyads.
#pragma once

#include "problems/mechanism/drawn/drawing.hpp"
#include "problems/mechanism/drawn/groups.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Faults a drawing whose links are held twice, hang loose or form groups that are no dyads; it
/// says which. `place`: the table of the joints.
void check_drawing(const Drawing& drawing, const DrawnGroups& groups, TableReader& place);

}  // namespace cognate::problems::reading
