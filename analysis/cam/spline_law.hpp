/// @file Interpolating splines as motion laws.
#pragma once

#include "analysis/cam/motion_law.hpp"

namespace cognate::cam {

/// `append_pieces` of a spline: one piece between each two points. False where the points are not
/// in order strictly inside the segment, a periodic spline does not end where it begins, or the
/// degree is neither 3 nor 5.
bool append_spline(const MotionSegment& segment, double begin, double start, int index,
                   std::vector<MotionPiece<double>>& pieces);

}  // namespace cognate::cam
