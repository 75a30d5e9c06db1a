/// @file What `cognate solve` prints of cams.
#pragma once

#include <string>

#include "app/console/screen.hpp"
#include "problems/cam/result.hpp"

namespace cognate::app {

/// A heading, the status in words, one row for each of the first 20 designs (number, lengths,
/// greatest pressure angles of rise and return and least convex radius of curvature, each with the
/// cam angle of its place, constraints, origin), then what a design violates, what proves the size
/// of the best one, the notes, and the time. Angles are in degrees. On a screen with colours these
/// mark what is met and missed.
std::string cam_table(const problems::CamProblem& problem, const problems::CamResult& result,
                      const Screen& screen);

}  // namespace cognate::app
