/// @file The involute function and its inverse.
#pragma once

namespace cognate::gear {

/// inv α = tan α − α of an angle in radians, |α| < π/2, to a few units in the last place: near 0,
/// where the difference cancels, by its series.
double involute(double angle);

/// The angle whose involute is `value`, of either sign, to a few units in the last place, for every
/// finite argument; beyond what an angle below π/2 can have, π/2 as it is rounded.
double involute_angle(double value);

}  // namespace cognate::gear
