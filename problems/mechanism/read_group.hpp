/// @file `[[dyad]]` with `type = "group"`: four bodies or more that close together.
#pragma once

#include "problems/mechanism/read_chain.hpp"

namespace cognate::problems::reading {

/// Takes note of the pins that a group names, but for points that others have named.
void announce_joints(TableReader& table, PartNames& names);

/// Adds the group in `table` to `chain`: its bodies, and its pins as points of these. A fault where
/// it has not three joints for two bodies, where its joints are apart in the places given, or where
/// it is at a dead point there; then `chain.names.incomplete` is set.
void read_group(TableReader& table, Chain& chain);

}  // namespace cognate::problems::reading
