/// @file The search for chains that generate a function.
#pragma once

#include <vector>

#include "problems/chain_function/model.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {

/// A minimum, in the unit of its space.
struct ChainFunctionMinimum {
  const ChainFunctionSpace* space = nullptr;
  ChainFunctionDesign design;
  double error = 0;  ///< radians: root mean square or the largest
};

struct ChainFunctionSearch {
  std::vector<ChainFunctionMinimum> designs;  ///< best first; different ones
  synthesis::SearchStatistics statistics;
};

/// Least-squares or minimax fits from drawn chains, then from disturbed good designs; limits
/// between samples are asked anew after each fit.
ChainFunctionSearch search_chain_functions(const std::vector<ChainFunctionSpace>& spaces,
                                           const Solve& options, const Run& run,
                                           const Deadline& deadline, Work& work);

}  // namespace cognate::problems
