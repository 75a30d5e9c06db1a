/// @file From positions in the plane to the coordinates of the equations.
#pragma once

#include <span>

#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::synthesis::nine_point {

/// A problem in its coordinates, or why there is none: wrong_count, not_finite or coincident.
struct SystemOrStatus {
  ExactPathStatus status = ExactPathStatus::solved;
  std::array<int, 2> coincident{};
  PathSystem system;
};

/// How many positions there may be: those of a class, or any two or more.
enum class Count { of_class, any };

/// The reference is the first pose, or the first position where the orientations do not count.
SystemOrStatus make_system(std::span<const PathPose> positions, Count count = Count::of_class);

}  // namespace cognate::synthesis::nine_point
