/// @file A generic problem of each class with all its solutions, from which those of every other
/// problem are reached.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/exact/nine_point/path_parameters.hpp"
#include "synthesis/exact/nine_point/tracker.hpp"

namespace cognate::synthesis::nine_point {

/// A problem of random complex data and its solutions, one of each triplet or pair.
struct StartSet {
  PathParameters data;
  std::vector<Pair> roots;  ///< unknowns(kind.points) numbers each

  int count() const { return static_cast<int>(roots.size()) / unknowns(data.kind.points); }
  std::span<const Pair> root(int i) const {
    const std::size_t size = unknowns(data.kind.points);
    return std::span(roots).subspan(i * size, size);
  }
};

/// The number of solutions of a class up to symmetry: 1442, 1112, 201, 30 or 6; 0 of no class.
int known_count(const PathClass& kind);

/// How a start set was found.
struct MonodromyCounts {
  int rounds = 0, paths = 0, failed = 0;
};

/// Finds the solutions of a generic problem by monodromy (Duff et al., IMA J. Numer. Anal. 39,
/// 2019): a random four-bar is a solution of the problem of its own positions. If the data go to
/// the same positions in another order, a solution goes to another one; such loops are repeated
/// with all that are new, until none is missing or nothing new has come for long. The same numbers
/// come out of every run on a machine, for any number of threads. Empty when stopped, or where the
/// seed is of no use.
std::optional<StartSet> find_start_set(const PathClass& kind, const TrackingOptions& means,
                                       MonodromyCounts* counts = nullptr, unsigned seed = 1);

}  // namespace cognate::synthesis::nine_point
