/// @file Whether a mechanism comes to a dead point within its tolerances.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/tolerance/affine_mechanism.hpp"
#include "analysis/tolerance/response.hpp"
#include "synthesis/bounds/interval.hpp"

namespace cognate::problems {

/// The dyad that comes nearest to a dead point, or first to one.
struct DeadPoint {
  std::size_t dyad = 0;
  double drive = 0;
  bool nominal = false;  ///< there the nominal mechanism stands at it: a change point
};

/// The place where a dyad of the mechanism stands at a dead point for some dimensions in `box`, by
/// a sound bound of its discriminant where that is least over the motion (between stations by the
/// golden section); empty where there is none.
std::optional<DeadPoint> dead_point_within(const AffineMechanism& mechanism,
                                           std::span<const Station> motion,
                                           std::span<const double> drive,
                                           std::span<const synthesis::Interval> box);

}  // namespace cognate::problems
