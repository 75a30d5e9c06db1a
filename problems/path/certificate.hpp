/// @file The certificate of timed path generation.
#pragma once

#include "problems/linkage/certifying.hpp"
#include "problems/path/problem.hpp"
#include "synthesis/lanes/path_proof.hpp"

namespace cognate::problems {

/// What a file's constraints leave to look at, in units of the path's size.
struct PathDomain {
  /// One for each sense in which the crank may turn.
  std::vector<synthesis::PathBound> bounds;
  /// Likewise, where all four proportions are unknown; else empty.
  std::vector<synthesis::PathProver> provers;
  std::vector<synthesis::ProportionBox> roots;
  double to_file = 1;  ///< sums of squares in the file's unit for one in the path's
  std::string text;
};

/// Of a problem with prescribed timing. Limits that would make the bound no better or cost it too
/// much are left out, so that more designs are looked at than the file allows: those of the
/// rocker's pivot, of a crank pivot that is not given, of the frame's direction unless it is given,
/// the three defects, and with four unknowns limits of lengths beyond what their ratios say.
PathDomain path_domain(const PathProblem& problem);

/// The weighted sum of squares that the search minimises, in the file's unit.
double path_objective(const PathProblem& problem, const Design& design);

/// Proves how much better than `upper` a design may be.
Certificate certify(const PathProblem& problem, double upper, const Run& run,
                    const Deadline& deadline);

}  // namespace cognate::problems
