/// @file Directions in SIMD lanes, as unit vectors. Include in kernels alone.
#pragma once

#include "analysis/numbers/vec2.hpp"
#include "synthesis/lanes/lane_numbers.hpp"

namespace cognate::synthesis::COGNATE_ISA {

using Direction = Vec2<Real>;

/// `direction` turned by arctan(tangent): by its argument, but for the cube of that.
inline Direction turned(const Direction& direction, const Real& tangent) {
  const Real inverse = Real(1.0) / root(Real(1.0) + tangent * tangent);
  return inverse * (direction * Direction{Real(1.0), tangent});
}

inline Direction choose(const Mask& lanes, const Direction& yes, const Direction& no) {
  return {choose(lanes, yes.x, no.x), choose(lanes, yes.y, no.y)};
}

inline void set_lane(Direction& direction, int lane, const double* to) {
  set_lane(direction.x, lane, to[0]);
  set_lane(direction.y, lane, to[1]);
}

inline double lane_of(const Real& value, int lane) {
  double values[kLanes];
  store(value, values);
  return values[lane];
}

inline void get_lane(const Direction& direction, int lane, double* to) {
  to[0] = lane_of(direction.x, lane);
  to[1] = lane_of(direction.y, lane);
}

}  // namespace cognate::synthesis::COGNATE_ISA
