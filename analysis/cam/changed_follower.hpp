/// @file Where a cam that is as designed puts a follower that is not.
#pragma once

#include <array>
#include <optional>

#include "analysis/cam/cam.hpp"

namespace cognate::cam {

/// By how much the follower stands from where it should at cam angle `angle` (length, or radians of
/// an oscillating one), if its dimensions are off by `changes`. The profile is that of the cam as
/// designed; a change of the base radius raises it by as much along its normals. The contact is
/// found anew: the roller's centre on the parallel of the pitch curve that its path or arm crosses,
/// the face on the tangent. Empty where it is not found, or undercut.
std::optional<double> misplacement(const Cam& cam, const CamDimensions<double>& changes,
                                   double angle);

/// Its derivatives by the dimensions, in the order of CamDimensions' members, at no change: with
/// the pressure angle α, 1/cos α along the normal and tan α across it, over the arm of an
/// oscillating follower.
std::array<double, 6> misplacement_rates(const Cam& cam, double angle);

}  // namespace cognate::cam
