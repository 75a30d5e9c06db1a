/// @file Fits to a closed curve that run elsewhere between its samples.
#pragma once

#include <optional>
#include <span>

#include "analysis/linkage/four_bar.hpp"
#include "problems/path/curve/closed_curve.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// For a problem whose samples are those of a closed curve: rejects minima that meet the samples
/// but stray between them. Without it, the best few of a search would all be such minima.
class DeviationBetweenSamples {
 public:
  explicit DeviationBetweenSamples(const PathProblem& searched);

  /// Whether the coupler curve has a loop far from the samples, where that is not allowed, or meets
  /// them in another order than one turn of the crank does, likewise. Never so for other problems.
  bool strays(const FourBar& linkage, std::span<const double> crank_angles) const;

 private:
  const PathProblem& problem_;
  std::optional<ClosedCurve> outline_;  ///< through the samples; none where loops do not matter
};

}  // namespace cognate::problems
