/// @file What a function generator that is a chain is and whether it satisfies its problem,
/// computed by the evaluator of mechanisms body by body.
#pragma once

#include <array>

#include "analysis/mechanism/kinematics.hpp"
#include "problems/chain_function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The error that is minimised.
ErrorMeasure error_measure(const ChainFunctionProblem& problem);
double error_of(const ChainFunctionProblem& problem, const Design& design);

/// The structural error of a mechanism whose crank starts at an angle.
class ChainFunctionError {
 public:
  /// The output's start is that of the least error: of its mean square, or with minimax of its
  /// greatest magnitude, over the samples.
  ChainFunctionError(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                     const NamedMechanism& mechanism, double start);

  /// The output's angle less the wanted one, radians; infinite where the chain does not close.
  double at(const synthesis::AnglePair& pair) const;
  /// The output's angle at the start, from the x axis.
  double output_start() const;

 private:
  double start_;
  mutable MechanismMotion<0> motion_;
  std::array<Attached<double>, 2> points_;
  Vec2d reference_{1, 0};
};

/// `mechanism`, of the topology, its crank at `start` from the x axis at the start of the function,
/// with its errors, the transmission angles of each joint over the motion limited, and checks.
Design verified(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                const Topology& topology, NamedMechanism mechanism, double start);

}  // namespace cognate::problems
