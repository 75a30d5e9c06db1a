/// @file The involute function and its inverse.
#pragma once

namespace cognate::gear {

/// inv α = tan α − α of an angle in radians, |α| < π/2, to a few units in the last place also where
/// the difference cancels. Not a number of what is none.
double involute(double angle);

/// The angle whose involute is `value`, of either sign, to one or two units in the last place for
/// every finite argument; π/2 as it is rounded where no lesser double has so great an involute.
double involute_angle(double value);

/// The same of an angle in degrees, |α| < 90°: towards 90° by its complement, which is exact in
/// degrees, so that no digit is lost to the angle's conversion.
double involute_of_degrees(double degrees);

/// The angle in degrees whose involute is `value`.
double involute_angle_in_degrees(double value);

}  // namespace cognate::gear
