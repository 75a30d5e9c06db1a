/// @file What a curve does between the targets that it meets.
#pragma once

#include <span>

#include "problems/chain/scaled.hpp"

namespace cognate::problems {

/// How far the traced point strays from the straight ways between neighbouring targets, mean
/// square, at three crank angles between those of each pair (`angles`). By so much as it misses the
/// two, and half of the longest way next to them, a curve may leave the way. Without it, loops and
/// overshoots between targets would count for nothing. 0 for a timed path, and a motion, whose
/// poses have no way between them; infinite where the chain does not close. `targets` are in units
/// of the problem.
double squared_stray(const ScaledChain& problem, const synthesis::ChainDesign& design,
                     std::span<const Vec2d> targets, std::span<const double> angles);

}  // namespace cognate::problems
