/// @file The closure of a driving cylinder and its link: circle and circle, the first of which
/// grows with the drive.
#pragma once

#include <array>

#include "analysis/mechanism/motion_terms.hpp"
#include "analysis/mechanism/rrr_motion.hpp"

namespace cognate {

/// With q the cylinder's length along e₁ and l the link's along e₂, base + q e₁ = pivot + l e₂: the
/// positions are those of a dyad RRR with links of q and l. In the derivatives q′ = 1 and no higher
/// one is left, so that e₁ and what it does to the turned e₁ join the right-hand side. Fills `rod`,
/// whose pin both circles meet in, too.
template <int Order, class T>
DyadMotion<T, Order> close_cylinder(const Cylinder<T>& dyad, const T& length, const T& side,
                                    BodiesBefore<T, Order> bodies, BodyMotion<T, Order>& rod) {
  const auto from = motion_of<T, Order>(dyad.base, bodies);
  const auto to = motion_of<T, Order>(dyad.pivot, bodies);
  const Rrr<T> triangle{dyad.base, dyad.pivot, length, dyad.length, dyad.assembly};
  const auto closed = close_rrr<0>(triangle, side, std::array{from[0]}, std::array{to[0]},
                                   diagonal(triangle, to[0] - from[0]));
  DyadMotion<T, Order> result;
  result.closure = closed.closure;
  BodyMotion<T, Order>&cylinder = result.first, &link = result.second;
  cylinder.direction = closed.first.direction;
  link.direction = closed.second.direction;
  cylinder.origin = from;
  link.origin = to;
  rod.direction = cylinder.direction;
  const Vec2<T> along = length * cylinder.direction, arm = dyad.length * link.direction;
  rod.origin[0] = from[0] + along;

  if constexpr (Order >= 1) {
    const T inverse_sine = T(1) / result.closure.sine;
    motion_terms::Sliding<T, Order> slide{cylinder.direction, {}};
    slide.rate[0] = T(1);
    motion_terms::for_each_order<Order>([&](auto order) {
      constexpr int kOrder = order();
      const Vec2<T> right = to[kOrder] - from[kOrder] +
                            motion_terms::turned_below<kOrder>(link, arm) -
                            motion_terms::turned_below<kOrder>(cylinder, along) -
                            motion_terms::slid<kOrder>(cylinder, slide);
      cylinder.turn[kOrder - 1] = inverse_sine / length * dot(right, link.direction);
      link.turn[kOrder - 1] = inverse_sine / dyad.length * dot(right, cylinder.direction);
      rod.origin[kOrder] = to[kOrder] + motion_terms::turned<kOrder>(link, arm);
    });
    rod.turn = cylinder.turn;
  }
  return result;
}

}  // namespace cognate
