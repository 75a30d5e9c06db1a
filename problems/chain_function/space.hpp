/// @file Which dimensions of a function generator that is a chain are sought, and for what.
#pragma once

#include <vector>

#include "problems/chain/cosine_scan.hpp"
#include "problems/chain/output/space.hpp"
#include "problems/chain_function/problem.hpp"
#include "problems/function/samples.hpp"

namespace cognate::problems {

/// What the output is to do: pairs of increments, as function_samples has them.
FunctionSamples function_samples(const ChainFunctionProblem& problem);

/// The problem of one topology. Outputs are in radians, those of a slider in the unit of the space.
struct ChainFunctionSpace : OutputSpace {
  std::vector<synthesis::AnglePair> coarse, fine;  ///< where the error counts in a search, at last
  Range sweep;                                     ///< of the crank from its start
  bool is_minimax, needs_turn;

  ChainFunctionSpace(const ChainFunctionProblem& problem, const Topology& topology,
                     const FunctionSamples& wanted);

  /// Where limits hold of a crank that starts at this angle.
  CrankSpan span(double start) const;
  /// The output wanted after the crank's increment `input`, linear between the coarse pairs.
  double output_at(double input) const;
};

}  // namespace cognate::problems
