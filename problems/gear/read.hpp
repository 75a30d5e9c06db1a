/// @file What a gear and a gear pair read alike.
#pragma once

#include <string_view>

#include "problems/gear/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// `[rack]`, the standard one where the file has none.
gear::BasicRack read_rack(TableReader& document);

/// Faults `table`'s `keys` where they are there: `why` they have no meaning, "spur gears have no".
void refuse_keys(TableReader& table, std::initializer_list<std::string_view> keys,
                 std::string_view why);

/// `helix_deg`, which helical gears must have and others have not.
double read_helix(TableReader& mechanism, Gearing gearing);

}  // namespace cognate::problems::reading
