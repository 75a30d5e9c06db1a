/// @file How near a dyad is to what it cannot reach.
#pragma once

#include <span>

#include "analysis/mechanism/mechanism.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate {

/// What a dyad has to span and what it can, in lengths; of slides alone, the sine of the angle
/// between them, which must not vanish.
///
///     RRR  |d|, the distance of its outer points: |l₁ − l₂| ≤ |d| ≤ l₁ + l₂
///     RRP  |h|, the distance of the point from the guide: ≤ l
///     RPR  |d|, the distance of block and pivot: ≥ |offset|
///     PRP, RPP  |sin|: > 0
///     cylinder  as RRR, with its length as l₁
struct Reach {
  double distance = 0;
  double least = 0;
  double most = 0;    ///< infinite where nothing bounds it
  double extent = 0;  ///< size of the coordinates from which `distance` comes
  bool is_sine = false;
};

/// Of `dyad` on `bodies` (those before it) at the drive's coordinate `drive`.
Reach reach(const Dyad<double>& dyad, std::span<const BodyMotion<double, 0>> bodies, double drive);

/// How much rounding may have changed the discriminant of dyad `index`, which has `reach` there. Of
/// mechanisms whose class has a tolerance (analysis/linkage/mobility.hpp) it is what makes a
/// discriminant of zero of lengths within that, so that the motion agrees with the class.
double discriminant_rounding(const Mechanism<double>& mechanism, int index, const Reach& reach);

}  // namespace cognate
