/// @file `[[motion]]`: the follower's motion over a turn of the cam.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads every segment into `problem.motion` and `problem.free_motion`, whose follower is known.
/// Together they must be one turn, begin and end on the base circle, and none may end below it.
void read_cam_motion(TableReader& document, CamProblem& problem);

/// The greatest displacement at an end of a segment.
double greatest_rise(const std::vector<cam::MotionSegment>& motion);

}  // namespace cognate::problems::reading
