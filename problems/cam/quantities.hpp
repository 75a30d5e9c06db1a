/// @file What a finished cam is like and whether it satisfies its problem, from its dimensions
/// alone.
#pragma once

#include <vector>

#include "problems/cam/extremes.hpp"
#include "problems/cam/result.hpp"

namespace cognate::problems {

/// What `extremes`, those of the design's own cam, say of the whole turn, as named in `cognate list
/// --metrics`: pressure angles with where they are, least radii of curvature, undercut, the
/// profile's radii, and where `problem` says enough: face width, roller speed, forces, torque,
/// stress, preload.
std::vector<Quantity> cam_quantities(const CamProblem& problem, const CamDesign& design,
                                     const CamExtremes& extremes);

/// Every constraint of `problem`, each checked by its own extreme, in the order of the file's keys.
std::vector<ConstraintCheck> cam_checks(const CamProblem& problem, const CamDesign& design,
                                        const CamExtremes& extremes);

/// The least preload with which a force-closed follower of `cam` never lifts off: no demand of the
/// motion is then negative. At least 0.
double least_preload(const cam::Cam& cam);

}  // namespace cognate::problems
