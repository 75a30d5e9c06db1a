/// @file The crank pivot seen from the limits of the stroke: coordinates, and how well determined.
#pragma once

#include "analysis/numbers/vec2.hpp"

namespace cognate::synthesis {

/// A crank pivot A by elliptic coordinates about the limits C₁ and C₂, lengths in units of h.
struct ArcPoint {
  double crank = 0;    ///< l₁/h
  double coupler = 1;  ///< l₂/h
  double height = 0;   ///< distance from C₁C₂ over h
};

/// What was given beside the limits and the time ratio, and fixes the pivot on its arc.
enum class PivotGiven { crank, coupler, place };

/// ‖M⁻¹‖ h/l₂, at least 1: by how much the place of A, relative to the coupler, changes with θ in
/// radians and with what was given, relative to itself. M holds their derivatives by A. `place`:
/// the gradient, in units of h, of what was given where that is a function of A's place.
double pivot_condition(const ArcPoint& point, PivotGiven given, const Vec2d& place = {});

}  // namespace cognate::synthesis
