/// @file Path generation by exact synthesis: four-bars through every point and pose.
#pragma once

#include <random>
#include <span>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/path/exact/designs.hpp"
#include "problems/path/problem.hpp"
#include "synthesis/exact/nine_point/fixed_parts.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::problems {

/// Every four-bar of the real plane through the positions of a problem with method `exact`, the
/// sound ones first, where positions and given parts make as many conditions as a four-bar has
/// dimensions (eight beside the reference); else the best of a sample of the family that there is.
/// `quantities` count what was found, `notes` say it in words.
Result solve_exactly(const PathProblem& problem, const Run& run);

/// Where the number of solutions over the complex numbers comes from: from theory for problems
/// without given parts; else counted by monodromy, whose last loops found no more if it `settled`.
struct Expectation {
  bool by_theory = true;
  bool settled = true;
};

/// Adds the counts of a complete solution: how many solutions there are over the complex numbers,
/// at infinity, lost, proved, and real.
void note_counts(const synthesis::ExactPathSolutions& solutions, const ExactRoots& roots,
                 const Expectation& expected, Result& result);

/// Notes why there are no solutions to report: positions that coincide or are no numbers,
/// conditions that are not independent, no time.
void note_status(const synthesis::ExactPathSolutions& solutions, Result& result);

/// Notes more points on one line or circle than the path of a four-bar has there, a tricircular
/// curve of order six: six. Only degenerate linkages meet them all. False where there are no more;
/// four on a line or five on a circle are reported all the same.
bool note_points_on_a_circle(std::span<const Vec2d> points, Result& result);

/// Notes three poses or more without a turn between them, which only parallelograms and sliders
/// give a body.
void note_equal_angles(std::span<const double> angles, Result& result);

/// Adds what the designs are worth: how many are sound, and what the others miss by.
void note_exact_designs(const std::vector<TracedDesign>& designs, Result& result);

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
