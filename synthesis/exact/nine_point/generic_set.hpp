/// @file The solutions of a generic problem with given parts, from which all others are reached.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "synthesis/exact/nine_point/constrained_tracker.hpp"
#include "synthesis/exact/nine_point/fixed_parts.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::synthesis::constrained {

struct GenericSet {
  Data data;
  std::vector<State> states;
  bool settled = false;  ///< the last loops found nothing new
};

/// With what a generic problem is solved.
struct GenericSearch {
  int threads = 0;                       ///< as many as the machine has for 0
  std::function<bool()> stop;            ///< asked often, from any thread
  std::function<void(double)> progress;  ///< grows towards 1 as loops are made
  std::filesystem::path cache;           ///< folder for what was found; none if empty
};

/// Whether two solutions of the same data are one, to six digits.
bool are_same(const State& a, const State& b);

/// How many conditions of a kind of problem, eight at most, are independent of one another where
/// the data are generic.
int generic_rank(const PathClass& kind, const FixedParts& given);

/// The set for a kind of problem, found once in a process and, with a folder, once on a machine.
/// Null when stopped.
std::shared_ptr<const GenericSet> generic_set(const PathClass& kind, const FixedParts& given,
                                              const GenericSearch& search);

/// The set that generic_set() has left in a folder; null where there is none that is whole and
/// solves the generic problem.
std::shared_ptr<const GenericSet> read_generic_set(const std::filesystem::path& folder,
                                                   const PathClass& kind, const FixedParts& given);

}  // namespace cognate::synthesis::constrained
