/// @file What a result says of a search on a raster.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problems/basics/quantity.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// The error that results report for the objective that a search minimises.
using ErrorOfObjective = std::function<double(double objective)>;

/// Counts and errors: "raster_combinations", "raster_error", "raster_bound", "rounded_error", …
/// (see `cognate list --metrics`).
std::vector<Quantity> raster_quantities(const synthesis::RasterResult& found,
                                        const ErrorOfObjective& error);

/// The same as sentences: how far the search came and what its bound is worth.
std::vector<std::string> raster_notes(const synthesis::RasterResult& found,
                                      const ErrorOfObjective& error);

}  // namespace cognate::problems
