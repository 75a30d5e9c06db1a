/// @file Which dimensions of a function generator that is a chain are sought, and for what.
#pragma once

#include <vector>

#include "problems/chain/cosine_scan.hpp"
#include "problems/chain/output_space.hpp"
#include "problems/chain_function/problem.hpp"
#include "problems/function/samples.hpp"

namespace cognate::problems {

/// What the output is to do: pairs of increments, as function_samples has them.
FunctionSamples function_samples(const ChainFunctionProblem& problem);

/// What the output is to be at a position: a direction, or the displacement of a slider.
struct WantedOutput {
  Vec2d direction{1, 0};
  double displacement = 0;
};

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

  WantedOutput wanted(double output) const;
  /// The output where `chain` is: the direction's angle from the x axis, or the displacement.
  double output(const FreeChain& chain) const;
  /// The same less what is wanted; an angle is within half a turn of that.
  double error(const FreeChain& chain, const WantedOutput& wanted) const;
  /// The derivatives of the output, as FreeChain has them.
  double output_slope(FreeChain& chain, double* row) const;
};

}  // namespace cognate::problems
