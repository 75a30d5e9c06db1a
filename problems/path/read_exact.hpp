/// @file `method = "exact"` of paths: positions and the other keys.
#pragma once

#include "problems/path/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// `target.poses` and `target.points`: two to nine positions, no two of them alike.
void read_exact_positions(TableReader& target, PathProblem& problem);

/// Faults what exact synthesis of paths has no use for, and more positions and given parts than a
/// four-bar has dimensions.
void check_exact_path(TableReader& target, TableReader& mechanism, TableReader& solve,
                      const PathProblem& problem);

/// More designs than any problem has; the default where there are finitely many.
inline constexpr int kMostExactDesigns = 10'000;

/// How many designs are returned where the file does not say: all, or the best three of a family.
int default_exact_designs(const PathProblem& problem);

}  // namespace cognate::problems::reading
