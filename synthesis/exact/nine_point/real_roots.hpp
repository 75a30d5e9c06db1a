/// @file The roots of real data: closed under conjugation, and the real ones among them.
#pragma once

#include <vector>

#include "synthesis/exact/nine_point/follow.hpp"
#include "synthesis/exact/nine_point/refine.hpp"

namespace cognate::synthesis::nine_point {

struct RealRoot {
  RootNumbers numbers;
  RootQuality quality;
  bool real = false;
};

/// Refines the roots of `paths`, adds the conjugates that are missing if paths were lost and if
/// Newton's method confirms them, and makes those real that are: first in the list. Paths that are
/// known thereby are no longer counted as lost, those to singular roots no longer as roots.
std::vector<RealRoot> find_real_roots(FollowedPaths& paths, const PathParameters& data,
                                      const TrackingOptions& means);

}  // namespace cognate::synthesis::nine_point
