/// @file Swings, strokes, classes, dead points and transmission of random mechanisms against brute
/// force.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace cognate::stress {

/// What a number of random mechanisms showed.
struct RangeTally {
  std::map<std::string, int> compared{};       ///< values held against brute force, by quantity
  std::map<std::string, int> disagreements{};  ///< by quantity
  std::map<std::string, std::string> first{};  ///< the file of the first of each, with both values
  std::map<std::string, int> classes{};        ///< of four-bars
  int mechanisms = 0;
  int none_closes = 0;  ///< in the drive
  int several_ranges = 0;
  int come_round = 0;  ///< outputs that turn on the whole circuit, not in the range
  int turn = 0;        ///< outputs that turn in the range driven
  int at_ties = 0;     ///< that count as change points
  int near_ties = 0;   ///< that do not, but are within 1e-3 of one

  int all_disagreements() const;
  int all_compared() const;
};

/// Analyses `count` mechanisms of `seed` of one loop.
RangeTally check_loops(std::uint64_t seed, int count);

/// Analyses `count` six-bars of `seed`: a four-bar with a dyad on its coupler. `several_ranges` are
/// those whose first range has a dead end.
RangeTally check_chains(std::uint64_t seed, int count);

}  // namespace cognate::stress
