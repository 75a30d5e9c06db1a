/// @file From the roots of exact path synthesis to designs.
#pragma once

#include <string>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"
#include "synthesis/exact/nine_point/certificate.hpp"
#include "synthesis/exact/nine_point/fixed_parts.hpp"

namespace cognate::problems {

/// Points and poses of a problem, in its order.
std::vector<synthesis::PathPose> positions_of(const PathProblem& problem);

/// The parts that `[mechanism]` gives.
synthesis::FixedParts given_parts(const Given& given);

/// How many equations beside the reference a problem has: 8 determine a four-bar.
int equation_count(const PathProblem& problem);

/// Roots of one system and what is proved of them.
struct ExactRoots {
  synthesis::PathSystem system;
  std::vector<synthesis::PathRoot> roots;
  std::vector<synthesis::RootCertificate> certificates;  ///< as many, or none
  synthesis::RootSymmetry symmetry = synthesis::RootSymmetry::none;
  std::string origin;  ///< "exact:…"
};

/// A design and the curve it traces: those of one root and its symmetry have one number.
struct TracedDesign {
  Design design;
  int curve = 0;
};

/// The linkages of the real roots, each driven from either end and with both cognates as far as
/// the symmetry allows, judged by the analysis kernel at the problem's points (the first of the
/// system's positions). Curves are numbered from `first_curve`.
std::vector<TracedDesign> designs_of(const ExactRoots& roots, const PathProblem& problem,
                                     int first_curve);

/// Feasible designs before others, those by their least transmission angle, these by how many
/// checks they fail and how far; at most `count`, with what traces an earlier one's curve marked.
std::vector<Design> ranked(std::vector<TracedDesign> designs, int count);

}  // namespace cognate::problems
