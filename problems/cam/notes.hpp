/// @file What a user should know of a cam beyond its numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/cam/result.hpp"

namespace cognate::problems {

/// Why the motion of `problem` cannot be had from any cam of the kind requested; nothing where it
/// can.
std::optional<std::string> motion_impossibility(const CamProblem& problem,
                                                const cam::MotionProgramme& programme);

/// Jumps of the motion, limits that meet at a cusp, sides of the pressure angle that no limit
/// counts.
std::vector<std::string> cam_notes(const CamProblem& problem, const CamResult& result);

}  // namespace cognate::problems
