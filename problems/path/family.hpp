/// @file Members of a family of four-bars: what is left free of a path problem, chosen at random.
#pragma once

#include <random>
#include <vector>

#include "problems/path/problem.hpp"
#include "synthesis/exact/nine_point/fixed_parts.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::problems {

/// A problem with as many equations as a four-bar has dimensions.
struct FamilyMember {
  std::vector<synthesis::PathPose> positions;  ///< the problem's, then those chosen
  synthesis::FixedParts parts;
};

/// Chooses what `free` equations are missing. The pivots where they are not more than that, each
/// within its bounds, the region of pivots and, where these have no limit, about the path: few
/// points and given pivots have few solutions, quickly found. What is still missing are points on a
/// smooth closed curve through those given, so that the linkages found are near it between the
/// points.
FamilyMember random_member(const PathProblem& problem, int free, std::mt19937_64& random);

}  // namespace cognate::problems
