/// @file What `[raster]` of a linkage is checked against.
#pragma once

#include <string_view>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/raster/raster.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// What of `[solve]` speaks against a raster: fronts, losses, certificates. Empty where nothing.
std::string_view search_raster_refusal(const Solve& solve);

/// The same of `solve.robust`.
std::string_view robust_search_refusal(const Solve& solve);

/// Faults a raster without any value within the bounds of a dimension that is not given.
void check_raster_bounds(TableReader& document, const Raster& raster, const Given& given,
                         const Bounds& bounds);

}  // namespace cognate::problems::reading
