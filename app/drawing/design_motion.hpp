/// @file The motion of a finished design, sampled for drawing.
#pragma once

#include <span>
#include <vector>

#include "analysis/linkage/four_bar.hpp"

namespace cognate::app {

/// A linkage driven through its range, angles in radians from the x axis. Crank and rocker angles
/// are continuous from sample to sample (they may leave a full turn); every array has one entry for
/// each sample.
struct DesignMotion {
  bool full_turn = false;      ///< whether the last sample is the first one again
  std::vector<double> crank;   ///< increasing
  std::vector<double> rocker;  ///< of D→C
};

/// `count` ≥ 2 samples of `linkage`: over the full turn from 0 to 2π if its crank turns fully, else
/// over the range in which the linkage closes that contains `crank_angles` (the first range if none
/// does). At the ends of such a range the rocker moves as the square root of the crank, so samples
/// lie there more densely. Empty arrays where the links never close.
DesignMotion sample_motion(const FourBar& linkage, std::span<const double> crank_angles, int count);

}  // namespace cognate::app
