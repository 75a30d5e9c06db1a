#include "analysis/linkage/double_slider.hpp"

#include <cmath>

namespace cognate {

Mechanism<double> as_mechanism(const ScotchYoke& mechanism) {
  const Rpp<double> dyad{.point = {1, {mechanism.crank, 0}},
                         .slot = mechanism.slot,
                         .guide = {0, mechanism.pivot, mechanism.direction, mechanism.offset}};
  return {Crank<double>{mechanism.pivot, mechanism.crank}, {dyad}};
}

Mechanism<double> as_mechanism(const TangentGenerator& mechanism) {
  const Prp<double> dyad{.first = {.body = 1},
                         .second = {0, mechanism.pivot, mechanism.direction, mechanism.offset}};
  return {Crank<double>{mechanism.pivot, std::abs(mechanism.offset)}, {dyad}};
}

Mechanism<double> as_mechanism(const EllipticTrammel& mechanism) {
  const Vec2d second = mechanism.direction * mechanism.second_line;
  return {FloatingLink<double>{.first = {0, mechanism.centre, mechanism.direction},
                               .second = {0, mechanism.centre, second},
                               .length = mechanism.length},
          {}};
}

Mechanism<double> as_mechanism(const OldhamCoupling& mechanism) {
  const Vec2d distance = mechanism.pivot_d - mechanism.pivot_a;
  const Rpp<double> dyad{
      .point = {0, mechanism.pivot_d}, .slot = mechanism.slot, .guide = {.body = 1}};
  return {Crank<double>{mechanism.pivot_a, std::hypot(distance.x, distance.y)}, {dyad}};
}

}  // namespace cognate
