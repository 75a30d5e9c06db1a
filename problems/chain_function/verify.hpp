/// @file What a function generator that is a chain is and whether it satisfies its problem,
/// computed by the evaluator of mechanisms body by body.
#pragma once

#include <array>
#include <optional>

#include "problems/chain/crank_motion.hpp"
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

  /// The output less the wanted one; infinite where the chain does not close.
  double at(const synthesis::AnglePair& pair) const;
  /// The output at the start: its angle from the x axis, or the slider's displacement from the foot
  /// of the pivot from which the guide's offset counts.
  double output_start() const { return level_; }

 private:
  std::optional<double> output(double input) const;

  double start_;
  mutable CrankMotion motion_;
  std::optional<Guide<double>> guide_;        ///< of a slider
  std::array<Attached<double>, 2> points_{};  ///< of a slider the second alone: its pin
  double level_ = 0;                          ///< the output at the start
};

/// The errors of a mechanism whose crank starts at an angle, at the samples, the greatest also
/// between them; infinite where the chain does not close.
TargetError function_error(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                           const NamedMechanism& mechanism, double start);

/// `mechanism`, of the topology, its crank at `start` from the x axis at the start of the function,
/// with its errors, the transmission angles of each joint over the motion limited, and checks.
Design verified(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                const Topology& topology, NamedMechanism mechanism, double start);

}  // namespace cognate::problems
