/// @file The first stage of a function search: many starts, each brought near its minimum.
#pragma once

#include <vector>

#include "problems/function/found.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {

struct ExploredFunctions {
  std::vector<FunctionFound> minima;  ///< of least squares, best first
  std::vector<FunctionFound> starts;  ///< of a minimax problem: where the search began
  SearchStatistics statistics;
};

/// The least-squares minima that starts lead to. Until more starts promise nothing new, or as many
/// as the file says; `kept` minima go on. Penalties of violated limits are part of the objectives.
/// What is passed must outlive what is returned.
ExploredFunctions explore_functions(const FunctionRefiner& refiner, const FunctionSamples& wanted,
                                    std::size_t kept, const Run& run, const Deadline& deadline,
                                    Work& work);

}  // namespace cognate::problems
