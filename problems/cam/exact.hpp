/// @file The smallest cam in closed form, where the limits allow it.
#pragma once

#include <optional>

#include "analysis/cam/follower.hpp"
#include "analysis/cam/motion_programme.hpp"
#include "problems/cam/result.hpp"

namespace cognate::problems {

/// The smallest cam under the limits of pressure angle (of curvature, for a sliding flat face), and
/// what proves it. Other limits are not looked at: where the cam keeps them it is the answer, else
/// a start, and its proof a lower bound all the same.
struct ExactCam {
  cam::CamDimensions<double> dimensions;
  SizeProof proof;
};

/// For size as the objective, nothing of the motion free, and besides the base radius free: of a
/// translating roller or knife edge nothing or the offset; of an oscillating roller or knife edge
/// the centre distance; of a sliding flat face nothing; a roller's radius may be free too. Nothing
/// else.
std::optional<ExactCam> exact_cam(const CamProblem& problem, const cam::MotionProgramme& programme);

}  // namespace cognate::problems
