/// @file Where a follower rises, falls and dwells.
#pragma once

#include "analysis/cam/motion_programme.hpp"

namespace cognate::cam {

/// The parts of `pieces` in order, cut where the velocity changes its sign. Velocities below 1e-13
/// of the greatest are rest.
std::vector<StrokePart> stroke_parts_of(const std::vector<MotionPiece<double>>& pieces);

}  // namespace cognate::cam
