/// @file One run of an algorithm of NLopt on a program; internal to the back ends.
#pragma once

#include <nlopt.h>

#include <Eigen/Core>

#include "synthesis/optimise/foreign_solvers.hpp"
#include "synthesis/optimise/program.hpp"

namespace cognate::synthesis {

/// An algorithm of NLopt and what it knows. Constraints beyond that are taken into its objective by
/// the augmented Lagrangian of Birgin and Martínez (2008), NLopt's AUGLAG.
struct NloptMethod {
  enum class Constraints { none, few_inequalities, all };

  nlopt_algorithm algorithm;
  bool with_gradients;
  Constraints constraints;
  /// Searches a box for its global minimum; else descends from the start.
  bool global = false;
  /// Of the local searches that start a global one off (MLSL); else `algorithm` itself.
  nlopt_algorithm local = algorithm;
};

/// Where a method may go and how long; the bounds are of the program's size.
struct NloptLimits {
  Eigen::VectorXd lower, upper;
  int evaluations = 0;  ///< 0: `Options::max_iterations` is the limit
};

/// Minimises `program` from its start. An iteration is a gradient, or for a method without
/// gradients as many evaluations as a gradient by differences would take.
///
/// Where the model has no value, a local method receives ten times the largest objective seen,
/// without slope, which turns its line search back. A global one minimises f/(1 + f) < 1 in place
/// of f and receives 2 there: the order of values is the same, and no slope that it estimates is
/// spoilt. Global methods that have used up their evaluations have `converged`.
Outcome run_nlopt(const NloptMethod& method, Program& program, const NloptLimits& limits,
                  const Options& options);

}  // namespace cognate::synthesis
