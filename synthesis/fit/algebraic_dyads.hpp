/// @file Dyads near many poses, by linear algebra alone.
#pragma once

#include <span>
#include <vector>

#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// The links (rr) of least algebraic error over five poses or more, at most four, each of its mean
/// length over the poses.
///
/// That a point m of the body stays at one distance from g is, for the pose z → d + e z, linear in
/// seven products of the pivots' homogeneous coordinates and a constant:
///
///     h |d|²/2 + Re(d̄ e w) − Re(d̄ g) − Re(e q) + k = 0,        q = w ḡ
///
/// (general circles and lines of the image space: Ge, Purwar, Zhao & Deshpande 2017, "A task-driven
/// approach to unified synthesis of planar four-bar linkages using algebraic fitting of a pencil of
/// G-manifolds"). The three right singular vectors of least singular value of these conditions,
/// their means taken out, are searched for the vectors that are made of two pivots. Where a
/// four-bar carries the body through the poses both its links are among the answers, to rounding
/// times condition.
std::vector<GuidingDyad> algebraic_dyads(std::span<const Pose> poses);

}  // namespace cognate::synthesis
