/// @file What a result says of a search on a raster.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/basics/quantity.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// The error that results report for the objective that a search minimises.
using ErrorOfObjective = std::function<double(double objective)>;

/// What is best on the raster, by its word in keys and sentences: "error", "length", "size".
struct RasterMeasure {
  ErrorOfObjective of;
  std::string_view word = "error";
};

/// Counts and errors: "raster_combinations", "raster_error", "raster_bound", "rounded_error", …
/// (see `cognate list --metrics`).
std::vector<Quantity> raster_quantities(const synthesis::RasterResult& found,
                                        const RasterMeasure& measure);
inline std::vector<Quantity> raster_quantities(const synthesis::RasterResult& found,
                                               const ErrorOfObjective& error) {
  return raster_quantities(found, RasterMeasure{error});
}

/// The same as sentences: how far the search came and what its bound is worth.
std::vector<std::string> raster_notes(const synthesis::RasterResult& found,
                                      const RasterMeasure& measure);
inline std::vector<std::string> raster_notes(const synthesis::RasterResult& found,
                                             const ErrorOfObjective& error) {
  return raster_notes(found, RasterMeasure{error});
}

}  // namespace cognate::problems
