/// @file What analysing a gear, and analysing or designing a gear pair, gives.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "problems/evaluation/result.hpp"
#include "problems/gear/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A gear: its quantities, and a table of its flank.
struct GearResult {
  Status status = Status::no_solution;  ///< `infeasible`: an impossible gear, with notes
  std::vector<Quantity> metrics;
  std::vector<Column> columns;  ///< radius, x, y, thickness… is_involute: one row for each point
  Work work;
  std::vector<std::string> notes;
};

/// A pair that was found, or given.
struct GearPairDesign {
  /// Transverse sections of spur and helical gears; of a bevel pair its virtual gears.
  gear::SpurPair pair;
  GearPairProblem settled;  ///< the problem with everything that it left free as this design has it
  std::vector<Quantity> metrics;
  std::vector<ConstraintCheck> constraints;
  std::string origin;
};

struct GearPairResult {
  Status status = Status::no_solution;
  std::vector<GearPairDesign> designs;  ///< best first
  std::vector<Quantity> quantities;  ///< of the enumeration: how many were tested and why refused
  Work work;
  std::vector<std::string> notes;
};

GearResult analyse(const GearProblem& problem, const Run& run);

/// Whether pairs of this gearing are searched for; others are evaluated, all being given.
constexpr bool is_searched(Gearing gearing) {
  return gearing == Gearing::spur || gearing == Gearing::helical;
}

/// Whether nothing is left to find.
bool is_whole(const GearPairProblem& problem);

/// The best pairs for `problem`; of one that is whole, what it is like.
GearPairResult solve(const GearPairProblem& problem, const Run& run);

}  // namespace cognate::problems
