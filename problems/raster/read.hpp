/// @file `[raster]` read and written.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "problems/raster/raster.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// The table of `document`, if there is one. `keys`: of `kRasterKeys`, those that the kind of
/// problem has. `refusal`: what speaks against any raster, "is given with …; remove it"; mostly
/// empty.
std::optional<Raster> read_raster(TableReader& document, std::span<const std::string_view> keys,
                                  std::string_view refusal);

/// Faults `key` of the raster where none of its values lies within `range`, that of `bounds_key`.
void check_raster_values(TableReader& document, const Raster& raster, std::string_view key,
                         std::string_view group, const Range& range, std::string_view bounds_key);

/// `raster`, of which that is read, where there is one.
Table raster_table(const std::optional<Raster>& raster);

}  // namespace cognate::problems::reading
