/// @file A run on a raster: the search between its values, then the search on them, in the end of
/// single combinations side by side.
#pragma once

#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Share of the run, for progress, at the end of the search between the values.
inline constexpr double kBetweenValuesDone = 0.2;

inline Run between_values(const Run& run) {
  run.enter(Phase::search, kBetweenValuesDone);
  return part_of(run, 0, kBetweenValuesDone);
}

inline Run on_values(const Run& run) {
  run.enter(Phase::raster);
  return part_of(run, kBetweenValuesDone, 1);
}

/// That of one combination beside others: its search begins with no design known.
inline Run of_one_combination(const Run& run) {
  Run one = silent(run);
  one.threads = 1;
  one.known.clear();
  return one;
}

}  // namespace cognate::problems
