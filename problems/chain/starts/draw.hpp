/// @file Chains drawn at random, all of which can be assembled over the whole turn of the crank or
/// where it is to turn.
#pragma once

#include <array>
#include <optional>
#include <random>

#include "problems/chain/space.hpp"

namespace cognate::problems {

/// Positions of the crank at which a drawn chain is known.
inline constexpr int kDrawnPositions = 64;

using DrawnCurve = std::array<Vec2d, kDrawnPositions>;

/// A chain with the path of its point, at equal steps of the crank from 0.
struct DrawnChain {
  synthesis::ChainDesign design;
  DrawnCurve curve;
};

/// A chain with the given dimensions of `space`, or where none is given with a crank of length 1
/// about the origin. Lengths of dyads follow from the least and the greatest distance of the points
/// that they join, so that transmission angles are within the limit by construction. Empty where
/// the draw came to nothing.
std::optional<DrawnChain> draw(const ChainSpace& space, std::mt19937_64& random);

/// The same for other positions, the directions `cranks` of the crank.
std::optional<DrawnChain> draw(const ChainSpace& space, const DrawnCurve& cranks,
                               std::mt19937_64& random);

}  // namespace cognate::problems
