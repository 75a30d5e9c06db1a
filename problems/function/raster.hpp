/// @file Function generators whose lengths lie on a raster.
#pragma once

#include <functional>
#include <vector>

#include "problems/function/generator.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/function/search.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

struct RasterFunctionResult {
  std::vector<FunctionGenerator> designs;  ///< best first, lengths exactly those of the raster
  synthesis::RasterResult search;
};

/// Whether a generator meets every constraint of the file. Called from many threads at once.
using FunctionAcceptance = std::function<bool(const FunctionGenerator& generator)>;

/// The minima of a problem that a search begun with none known finds. Called from many threads at
/// once.
using FunctionSearcher = std::function<std::vector<FunctionDesign>(const FunctionProblem& problem)>;

/// Searches the raster of `problem` from minima of the same problem without one. Where lengths are
/// free beside the raster, `search` is asked for those of the best combinations.
RasterFunctionResult search_function_raster(const FunctionProblem& problem,
                                            const FunctionSamples& wanted,
                                            const std::vector<FunctionDesign>& minima,
                                            const FunctionAcceptance& accepts,
                                            const FunctionSearcher& search, const Run& run,
                                            const Deadline& deadline);

}  // namespace cognate::problems
