/// @file A run on a raster: the search between its values, then the search on them.
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

}  // namespace cognate::problems
