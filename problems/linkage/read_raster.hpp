/// @file What `[raster]` of a linkage is checked against.
#pragma once

#include <optional>
#include <string_view>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// What of `[solve]` speaks against a raster: fronts, losses, certificates. Empty where nothing.
std::string_view search_raster_refusal(const Solve& solve);

/// The same of `solve.robust`; and why the tolerances are none that it can take into account.
std::string_view robust_search_refusal(const Solve& solve);
std::string_view robust_tolerance_refusal(const std::optional<Tolerances>& tolerances);

/// Faults a raster without any value within the bounds of a dimension that is not given.
void check_raster_bounds(TableReader& document, const Raster& raster, const Given& given,
                         const Bounds& bounds);

}  // namespace cognate::problems::reading
