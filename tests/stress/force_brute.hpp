/// @file Greatest and least driving torques and greatest reactions of random linkages by brute
/// force: closures, equations of motion and a search of their own, which share no code with the
/// program.
#pragma once

#include <cstdint>
#include <string>

namespace cognate::stress {

/// What a number of random linkages showed.
struct ForceTally {
  int linkages = 0;          ///< analysed
  int bounded = 0;           ///< extremes held against the brute force's
  int unbounded = 0;         ///< extremes that both found unbounded
  int reactions = 0;         ///< of both kinds, those of reactions
  int disagreements = 0;     ///< values, places or kinds that differ
  double worst = 0;          ///< relative difference of an extreme
  std::string first_file{};  ///< of the first disagreement, with what differs
};

/// Analyses `count` linkages of `seed`: four-bars (cranks that turn and that rock) and
/// slider-cranks, with masses, gravity, and loads that act always, in a sense, in an interval of
/// the drive (down to 1e-4°) or in a part of the stroke (down to 1e-4), over tables of 3 to 40
/// steps.
ForceTally check_forces(std::uint64_t seed, int count);

}  // namespace cognate::stress
