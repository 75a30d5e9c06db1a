/// @file Body guidance by four-bars whose dimensions lie on a raster.
#pragma once

#include <functional>
#include <vector>

#include "problems/guidance/design.hpp"
#include "problems/guidance/fit.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/scale.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// Two dyads on the raster and where they hold the body at each pose, in the file's unit.
struct RasterMotion {
  DyadPair pair;
  std::vector<synthesis::Pose> reached;
  double objective = 0;  ///< sum of squares, in the unit of the scale
};

struct RasterMotionResult {
  std::vector<RasterMotion> designs;  ///< best first, dimensions exactly those of the raster
  synthesis::RasterResult search;
};

/// Whether a mechanism meets every constraint of the file. Called from many threads at once.
using MotionAcceptance = std::function<bool(const RasterMotion& motion)>;

/// Searches the raster of `problem`, of which `scaled` is in the units of `scale`, from minima of
/// the same problem without one. Where dimensions are free beside the raster, the best combinations
/// are searched as problems of their own too. Counts that in `work`.
RasterMotionResult search_motion_raster(const MotionProblem& problem, const MotionProblem& scaled,
                                        const MotionScale& scale,
                                        const std::vector<MotionMinimum>& minima,
                                        const MotionAcceptance& accepts, const Run& run,
                                        const Deadline& deadline, Work& work);

}  // namespace cognate::problems
