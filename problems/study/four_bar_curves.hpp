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
  static constexpr std::size_t kMost = 64;

  FourBarCurves();

  /// Curves of no more than `kMost` linkages with coupler points.
  void sample(std::span<const FourBar> linkages);

  /// Of linkage i: whether its samples settle the length; and the sums over them.
  bool is_settled(std::size_t i) const { return sums_.is_settled(i); }
  double length(std::size_t i) const { return sums_.length[i]; }
  double area(std::size_t i) const { return sums_.area[i]; }

  /// The samples of linkage i, until this is called for another.
  CurveSamples curve(std::size_t i);

 private:
  CrankTable<double> cranks_;
  std::array<std::array<double, kMost>, 10> designs_{};
  CurveRoom samples_;  ///< sample j of linkage i at j·kMost + i
  CurveRoom one_;
  CurveSums sums_;
};

}  // namespace cognate::problems
