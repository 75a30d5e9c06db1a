/// @file Form-closed cams: what their second contact asks of the motion, and the second cam.
#pragma once

#include <optional>
#include <string>

#include "analysis/cam/cam.hpp"
#include "problems/cam/problem.hpp"

namespace cognate::problems {

/// By how much the sum s(δ) + s(δ + 180°), which two parallel contacts of one cam need constant,
/// varies over the turn, and where it is farthest from its value at δ = 0.
struct BreadthFault {
  double deviation = 0;
  double angle = 0;
};

/// Exact: on the pieces of both halves laid over each other.
BreadthFault breadth_fault(const cam::MotionProgramme& programme);

/// The distance of two parallel contacts of a cam whose sum s(δ) + s(δ + 180°) is constant: twice
/// the starting place and that sum.
double constant_breadth(const cam::Cam& cam);

/// The cam that drives the second roller of `first`'s follower: its programme is what the first one
/// lacks of its stroke. It is given as if its own roller stood above it: the cam of a translating
/// follower is mounted turned by 180°, that of an oscillating one as it is. Nothing where the
/// second roller would reach the shaft.
std::optional<cam::Cam> conjugate_cam(const cam::Cam& first, const SecondContact& contact);

}  // namespace cognate::problems
