/// @file A body held beside a dead point of its second dyad: the end of a motion on one side.
#pragma once

#include <array>
#include <optional>

#include "analysis/numbers/vec2.hpp"

namespace cognate::problems {

/// Beside which of its dead points a four-bar stands: coupler and rocker in line, stretched or
/// folded, the crank pin to the left or to the right of the line from A to D.
struct HeldDeadPoint {
  bool stretched = true;
  bool left = true;
  bool operator==(const HeldDeadPoint&) const = default;
};

/// Between coupler and rocker, or one and the other's extension, where a station is held: what
/// rounding may take from a linkage that is to close there is less than its square.
inline constexpr double kHeldFromDead = 1e-5;

/// Where it stands there, a small angle before the links are in line, and how that depends on the
/// ten dimensions of a motion model (dimensions.hpp).
struct DeadStation {
  static constexpr std::size_t dimensions = 10;

  double crank_angle = 0;
  Vec2d pin, turn;                             ///< the crank pin; the body's angle as a unit vector
  std::array<Vec2d, dimensions> pin_slopes{};  ///< of the pin by each dimension
  std::array<double, dimensions> turn_slopes{};  ///< of the body's angle
};

/// On the `side` of MotionForm, `from_dead` before the dead point. Empty where the crank does not
/// reach that or is in line with the frame there, and where coupler and rocker, nearly of one
/// length, fold so that the body spins.
std::optional<DeadStation> dead_station(const std::array<double, DeadStation::dimensions>& v,
                                        const HeldDeadPoint& at, double side,
                                        double from_dead = kHeldFromDead);

/// How the body turns there, the crank pin at rest, as the linkage leaves the dead point: by the
/// angle between coupler and rocker.
double turn_leaving(const std::array<double, DeadStation::dimensions>& v, const HeldDeadPoint& at,
                    double side);

/// The dead point that a four-bar is nearest to with its crank pin at `pin`.
HeldDeadPoint nearest_dead_point(const std::array<double, DeadStation::dimensions>& v,
                                 const Vec2d& pin);

}  // namespace cognate::problems
