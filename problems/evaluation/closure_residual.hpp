/// @file How far a mechanism's joints are from being joined, from the placements of its bodies.
#pragma once

#include <span>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate::problems {

/// Where a body's axes stand.
struct Placement {
  Vec2d origin{};
  Vec2d direction{1, 0};
};

/// Where `point` stands.
Vec2d place(std::span<const Placement> bodies, const Attached<double>& point);

/// The greatest distance between two pins that should be one, or of a slider's pin from its line,
/// in the mechanism's unit of length. Computed from the links' lengths and the placements alone,
/// with none of the closure's formulas.
double closure_residual(const Mechanism<double>& mechanism, std::span<const Placement> bodies);

/// The greatest distance of a body's origin from the global origin: what rounding of the placements
/// is proportional to.
double extent(std::span<const Placement> bodies);

}  // namespace cognate::problems
