/// @file Dwells of mechanisms whose dimensions lie on a raster.
#pragma once

#include <functional>
#include <vector>

#include "problems/dwell/search.hpp"
#include "problems/toml/table_reader.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// A mechanism on the raster, in the file's unit, its dimensions exactly those of the raster.
struct RasterDwells {
  std::vector<DwellDesign> designs;  ///< best first
  synthesis::RasterResult search;
};

/// Whether a mechanism, in the file's unit, meets every limit. Called from many threads at once.
using DwellAcceptance = std::function<bool(const DwellDesign& design)>;

/// Searches the raster of the problem of `space` from minima of the same problem without one. Where
/// dimensions are free beside the raster, the best combinations are searched as problems of their
/// own too. Counts that in `work`.
RasterDwells search_dwell_raster(const DwellSpace& space, const std::vector<DwellMinimum>& found,
                                 const DwellAcceptance& accepts, const Run& run,
                                 const Deadline& deadline, Work& work);

namespace reading {

/// The raster of a file all else of which is read.
void read_dwell_raster(TableReader& document, DwellProblem& problem);

}  // namespace reading

}  // namespace cognate::problems
