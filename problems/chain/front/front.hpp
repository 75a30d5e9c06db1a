/// @file Fronts of chains: the error weighed against another measure.
#pragma once

#include <functional>
#include <string>

#include "problems/chain/front/measures.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A problem of chains as the search of its front sees it.
struct ChainFrontProblem {
  ChainMeasure against;
  ChainDemand demand;
  double met = 0;                               ///< errors up to this are rounding
  double most = 0;                              ///< beyond this nobody wants a design
  std::string error;                            ///< its column in tables
  std::function<double(const Design&)> ranked;  ///< by which searches order designs
  std::function<double(const Design&)> shown;   ///< the error as tables say it
  /// Designs of least error that meet the demand, from `run.known` too.
  std::function<Result(const ChainDemand& demand, const Run& run, const Deadline&)> solve;
};

/// What `problem` demands.
template <class AnyProblem>
ChainDemand demand_of(const AnyProblem& problem) {
  return {problem.topologies, problem.constraints.transmission_angle, problem.solve};
}

/// The problem with this demand, which weighs its error against nothing.
template <class AnyProblem>
AnyProblem with_demand(const AnyProblem& problem, const ChainDemand& demand) {
  AnyProblem other = problem;
  other.topologies = demand.topologies;
  other.constraints.transmission_angle = demand.transmission_angle;
  other.solve = demand.solve;
  other.against.reset();
  return other;
}

/// Designs of which none is as good as another in both the error and the measure, best error first,
/// and the levels of both as a family "Pareto front". Where the measure is a number of
/// links, the best design of each; else a row of bounds on it, each searched from the designs
/// beside it too.
Result chain_front(const ChainFrontProblem& problem, const Run& run, const Deadline& deadline);

}  // namespace cognate::problems
