/// @file Starts for function generation.
///
/// Freudenstein's equation is linear in the ratios of the lengths once the start angles are chosen,
/// so the search over all linkages is one over two angles; the residual of the equation, weighted
/// by its slope in the output angle, is the structural error to first order. Where both start
/// angles are free the linkages through five of the samples are starts too. Where lengths are
/// fixed or the start is at a dead centre, random proportions take its place.
#pragma once

#include <cstdint>
#include <vector>

#include "problems/function/generator.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Where a start comes from: a draw, a linear fit of Freudenstein's equation to all samples (the
/// books' overlay), or exact synthesis through five of them.
enum class StartOrigin { search, overlay, five_points };

/// A generator to be refined, and its sum of squares over a part of the samples (per sample).
struct FunctionStartPoint {
  FunctionGenerator generator;
  double error = 0;
  StartOrigin origin = StartOrigin::search;
};

/// How starts are drawn.
struct StartSearch {
  std::uint64_t seed = 1;
  int threads = 1;
  int first = 0;                       ///< the first of the draws; fits come with number 0 alone
  int count = 48;                      ///< how many starts to return at most
  const Deadline* deadline = nullptr;  ///< when to give up; empty: never
};

/// What was found and how many designs were looked at.
struct FunctionStarts {
  std::vector<FunctionStartPoint> starts;  ///< best first within each kind, the kinds alternating
  std::uint64_t candidates = 0;
};

/// The best starts, within the lengths' limits and closing at every sample looked at. The same for
/// any number of threads.
FunctionStarts find_starts(const FunctionProblem& problem, const FunctionSamples& wanted,
                           const StartSearch& search);

}  // namespace cognate::problems
