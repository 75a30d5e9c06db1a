/// @file The certificate of timed path generation.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "problems/linkage/certifying.hpp"
#include "problems/path/problem.hpp"
#include "synthesis/lanes/path_proof.hpp"

namespace cognate::problems {

/// Where the file has no bounds of the coupler point it is taken to lie within so many times the
/// path's size of B.
inline constexpr double kFarthestPoint = 300;

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

/// A box and the sense of the crank that it is for: its place in `bounds`.
struct PathPart {
  synthesis::ProportionBox box;
  std::size_t sense = 0;
};

/// The whole of the domain.
std::vector<PathPart> whole_parts(const PathDomain& domain);

std::pair<PathPart, PathPart> halves(const PathPart& part, int side);

/// Of each part whether the proof is done with it, its bound being `target` or, for a time,
/// `first_target`, in units of the path's size.
void judge(const PathDomain& domain, std::span<const PathPart> parts, double target,
           double first_target, std::span<synthesis::StageVerdict> verdicts);

/// The weighted sum of squares that the search minimises, in the file's unit.
double path_objective(const PathProblem& problem, const Design& design);

/// Proves how much better than `upper` a design may be.
Certificate certify(const PathProblem& problem, double upper, const Run& run,
                    const Deadline& deadline);

}  // namespace cognate::problems
