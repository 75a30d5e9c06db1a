/// @file The numbers of each design of a study.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "problems/study/sampling.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

/// The designs of a study by number: the product of the grid, its last variable fastest, and of
/// each of its points all samples.
class DesignPoints {
 public:
  /// `study` outlives it.
  DesignPoints(const Study& study, std::uint64_t seed);

  /// Writes the values of the designs from `first` on, design by design, one for each variable, as
  /// many designs as there is room for.
  void fill(std::int64_t first, std::span<double> values);

 private:
  void fill_grid(std::int64_t point, std::span<double> values) const;
  void fill_samples(std::span<const double> unit, std::span<double> values) const;

  const Study* study_;
  std::vector<std::size_t> sampled_;  ///< the places of the sampled variables
  UnitPoints points_;
  std::vector<double> unit_;
};

/// `u` in [0, 1] of the way through `range`, of its logarithm where `logarithmic`.
double place_in(const Range& range, double u, bool logarithmic);

}  // namespace cognate::problems
