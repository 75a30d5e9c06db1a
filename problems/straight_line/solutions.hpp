/// @file The linkages, positions and points that a straight-line problem has, by the local theory.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/straight_line/problem.hpp"
#include "synthesis/exact/straight_line/contact_search.hpp"

namespace cognate::problems {

struct StraightLineSolutions {
  std::vector<synthesis::StraightLineSolution> all;
  std::vector<std::string> notes;  ///< why there are none, or none of some kind
  /// The position, where it is one; for the inflection circle.
  std::optional<synthesis::FamilyMember> position;
};

StraightLineSolutions find_solutions(const StraightLineProblem& problem);

/// The best designs by the goal; where it names neither length nor deviation, the front of relative
/// deviation and size over length ("straight-line front" among the families), designs evenly along
/// it. The same for any number of threads.
Result search_straight_lines(const StraightLineProblem& problem, const Run& run);

}  // namespace cognate::problems
