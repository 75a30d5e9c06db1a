/// @file Paths by four-bars whose dimensions lie on a raster.
#pragma once

#include <functional>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"
#include "problems/path/scale.hpp"
#include "problems/path/search.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// A four-bar on the raster, in the file's unit, its dimensions exactly those of the raster.
struct RasterPath {
  FourBar linkage;
  std::vector<double> crank_angles;  ///< at the points, from the x axis
};

struct RasterPathResult {
  std::vector<RasterPath> designs;  ///< best first
  synthesis::RasterResult search;
};

/// Whether a four-bar with its crank angles at the points, in the file's unit, meets every
/// constraint of the file. Called from many threads at once.
using PathAcceptance = std::function<bool(const RasterPath& design)>;

/// The minima of a scaled problem that a search begun with none known finds. Called from many
/// threads at once.
using PathSearcher = std::function<std::vector<PathMinimum>(const PathProblem& scaled)>;

/// Searches the raster of `problem`, from minima of the same problem without one: `scaled` by
/// `scale`, as the search has them. Where dimensions are free beside the raster, `search` is asked
/// for those of the best combinations.
RasterPathResult search_path_raster(const PathProblem& problem, const PathProblem& scaled,
                                    const PathScale& scale, const std::vector<PathMinimum>& minima,
                                    const PathAcceptance& accepts, const PathSearcher& search,
                                    const Run& run, const Deadline& deadline);

}  // namespace cognate::problems
