/// @file The global search for function generation: starts, their minima, and the best of those.
#pragma once

#include <vector>

#include "problems/function/found.hpp"
#include "problems/function/generator.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/function/starts.hpp"
#include "problems/linkage/result.hpp"
#include "problems/search/statistics.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// The solver that has the last word. A minimax design with fewer peaks than unknowns lies in a
/// valley that Gauss-Newton, knowing no curvature, walks slowly: there `auto` goes on with SLSQP.
synthesis::Solver finisher_of(const FunctionProblem& problem);

/// A local minimum and where its start came from.
struct FunctionDesign {
  FunctionGenerator generator;
  StartOrigin origin = StartOrigin::search;
};

struct FunctionSearchResult {
  std::vector<FunctionDesign> minima;  ///< best first, feasible ones before others
  SearchStatistics statistics;         ///< of the search for the objective's minima
};

/// Local minima of the objective; the same for any number of threads. Minimax designs have their
/// peaks between the samples levelled too. Counts what was done in `work`.
FunctionSearchResult search_functions(const FunctionProblem& problem, const FunctionSamples& wanted,
                                      const Run& run, const Deadline& deadline, Work& work);

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
