/// @file Curves of four-bars whose cranks turn fully, some at once on the batch kernel.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"
#include "analysis/coupler_curve/curve_measures.hpp"

namespace cognate::problems {

/// Samples curves over a whole turn of the crank, as many as lie in the fast memory of a core.
class FourBarCurves {
 public:
  /// Curves of `steps` samples each, `most` at once: a multiple of 8, which every set of
  /// instructions has lanes for.
  FourBarCurves(std::size_t steps, std::size_t most);

  std::size_t most() const { return most_; }

  /// Curves of no more than `most` linkages with coupler points.
  void sample(std::span<const FourBar> linkages);

  /// Of linkage i: whether its samples settle the length; and the sums over them.
  bool is_settled(std::size_t i) const { return sums_.is_settled(i); }
  double length(std::size_t i) const { return sums_.length[i]; }
  double area(std::size_t i) const { return sums_.area[i]; }

  /// The samples of linkage i, until this is called for another.
  CurveSamples curve(std::size_t i);

 private:
  std::size_t most_;
  CrankTable<double> cranks_;
  std::array<std::vector<double>, 10> designs_;
  CurveRoom samples_;  ///< sample j of linkage i at j·most + i
  CurveRoom one_;
  CurveSums sums_;
};

}  // namespace cognate::problems
