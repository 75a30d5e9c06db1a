/// @file All solutions of a problem, from a start set.
#pragma once

#include <vector>

#include "synthesis/exact/nine_point/path_parameters.hpp"
#include "synthesis/exact/nine_point/start_set.hpp"
#include "synthesis/exact/nine_point/tracker.hpp"

namespace cognate::synthesis::nine_point {

/// Where the paths of a start set lead.
struct FollowedPaths {
  std::vector<Pair> roots;  ///< distinct, unknowns(points) numbers each
  int at_infinity = 0, singular = 0, lost = 0, duplicates = 0, repeated = 0;
  bool stopped = false;
};

/// Fingerprints that agree so far, relative to their sizes, are those of one solution.
inline constexpr double kSameRoot = 1e-8;

/// Follows every path to `data`. One that can go no further changes to a cognate where it is, which
/// has other coordinates and so other singularities, and at last goes on with double-double
/// numbers. (Tighter tolerances do not help: what fails is precision.) Of paths that end at the
/// same place one has left its own: they are followed again more carefully.
FollowedPaths follow(const StartSet& set, const PathParameters& data, const TrackingOptions& means);

}  // namespace cognate::synthesis::nine_point
