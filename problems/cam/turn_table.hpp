/// @file A cam over its turn, as a table.
#pragma once

#include <vector>

#include "problems/cam/result.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::problems {

/// Columns over the cam angle, in degrees from 0 to 360 in `steps` equal steps: the follower's
/// displacement and its derivatives by the cam angle (and by time, where a speed is given), the
/// pressure angle, the point of the profile in the cam's own axes with its radius of curvature
/// (positive: convex; none where it is straight), of a roller the place of its centre, with masses,
/// springs or loads the contact force and the torque, with materials the contact stress. At the
/// border of two segments the row is the later one's. Of conjugate cams the first cam's.
std::vector<Column> turn_table(const CamProblem& problem, const CamDesign& design, int steps);

}  // namespace cognate::problems
