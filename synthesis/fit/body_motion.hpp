/// @file How far a body moves, wherever its origin lies.
#pragma once

#include <span>
#include <vector>

#include "synthesis/exact/motion/pose.hpp"

namespace cognate::synthesis {

/// The point of a body that moves least over its poses: the sum of squared distances of its places
/// from their mean is least. Where no pose is turned against another every point moves alike, and
/// this is the body's origin.
struct RestingPoint {
  Vec2d in_body;      ///< body axes
  Vec2d mean;         ///< of its places, in the fixed frame
  double travel = 0;  ///< root of the mean squared distance from `mean`
};

/// `poses`: at least one.
RestingPoint resting_point(std::span<const Pose> poses);

/// Where the body's point `in_body` stands at each pose, in the fixed frame.
std::vector<Vec2d> places_of(std::span<const Pose> poses, const Vec2d& in_body);

/// The poses of the fixed frame in the body's axes: the inverse motion, in which fixed and moving
/// pivots change places.
std::vector<Pose> inverse_motion(std::span<const Pose> poses);

}  // namespace cognate::synthesis
