/// @file In which sense a crank meets points one after another.
#pragma once

#include <span>

#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// Whether a crank that meets the points at `crank_angles` (from the x axis) turns in the sense
/// requested: that in which it turns less, going one way only.
ConstraintCheck check_sense(CrankSense wanted, std::span<const double> crank_angles);

/// Whether the problem lets the crank meet its points in either sense: by no angles of its own and
/// no choice between increments and their mirror image.
inline bool leaves_sense_open(const PathProblem& problem) {
  const bool by_increments = problem.crank_reference == CrankReference::first;
  return problem.timing == Timing::free || (problem.timing == Timing::mixed && !by_increments);
}

/// In which senses the crank can pass the timed points one after the other within one turn.
struct PossibleSenses {
  bool forward = true, backward = true;
};
PossibleSenses senses_between(const PathProblem& problem);

}  // namespace cognate::problems
