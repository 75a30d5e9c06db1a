/// @file Long lists of target points, looked at in part while the search is far from a design.
#pragma once

#include <span>
#include <vector>

#include "problems/path/problem.hpp"

namespace cognate::problems {

/// At most some points of a problem in even steps, the first and last among them, and as many of
/// the points that alone are timed. A problem with fewer points stays as it is.
class PathCoarsening {
 public:
  PathCoarsening(const PathProblem& problem, std::size_t most);

  const PathProblem& coarse() const { return coarse_; }
  bool is_whole() const { return kept_.size() == whole_size_; }

  /// Those of the kept points out of crank angles at all points.
  std::vector<double> kept(const std::vector<double>& crank_angles) const;

  /// Crank angles at all points from those at the kept ones, linear in between.
  std::vector<double> interpolated(std::span<const double> crank_angles) const;

 private:
  std::size_t whole_size_;
  std::vector<std::size_t> kept_;
  PathProblem coarse_;
};

}  // namespace cognate::problems
