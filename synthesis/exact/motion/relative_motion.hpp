/// @file Function generation as guidance of a body: crank and rocker seen from one another.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "synthesis/exact/freudenstein.hpp"
#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// The poses of the crank as the rocker sees it: in a frame fixed in the rocker, its origin at D
/// and its first axis at the output angle, the crank's body has its origin at A and its first axis
/// at the input angle. The coupler is then a dyad whose moving pivot is B in crank axes and whose
/// fixed pivot is C in rocker axes. A at the origin, D at (frame, 0); angles from A→D, in radians.
///
/// The link A–D itself guides the crank so: (moving, fixed) = ((0, 0), (0, 0)) is always a dyad.
std::vector<Pose> crank_seen_from_rocker(std::span<const AnglePair> pairs, double frame);

/// The four-bar whose coupler is an rr dyad of these poses.
struct FunctionLinkage {
  Lengths<double> links;
  double input_start = 0;   ///< angle from A→D of the crank A–B where the input angle is 0
  double output_start = 0;  ///< angle from A→D of the rocker D–C where the output angle is 0
};

/// Empty for a dyad with a slide, and for one without crank, coupler or rocker (as the frame is).
std::optional<FunctionLinkage> function_linkage(const GuidingDyad& coupler, double frame);

/// All four-bars that give five pairs of increments of input and output angle with start angles
/// free: at most three (the fourth dyad of the five poses is the frame).
std::vector<FunctionLinkage> function_linkages(std::span<const AnglePair, 5> pairs, double frame);

}  // namespace cognate::synthesis
