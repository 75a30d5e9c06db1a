/// @file Path problems in units of the path's own size, with its centroid as origin.
#pragma once

#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// Solvers see every path at the same place and of the same size, so that a problem moved or
/// enlarged gives the same designs moved or enlarged.
struct PathScale {
  Vec2d centre;     ///< weighted centroid of the points
  double size = 1;  ///< root of the weighted mean squared distance from it

  explicit PathScale(const PathProblem& problem);

  PathProblem into(PathProblem problem) const;  ///< file units → path units
  FourBar into(const FourBar& linkage) const;
  FourBar out_of(const FourBar& linkage) const;  ///< path units → file units

 private:
  Given given_;
};

}  // namespace cognate::problems
