/// @file The closures of the dyads with slides: RRP, RPR, PRP and RPP.
///
/// Each position is the intersection of circles or lines, without trigonometry; each order of the
/// derivatives solves the same two linear equations. Axes and signs are those of mechanism.hpp.
#pragma once

#include <cmath>
#include <span>

#include "analysis/mechanism/dyad_parts.hpp"

namespace cognate {

/// Circle and line. With v along the guide and h the signed distance of the guide from the point,
/// the pin stands at t v + h i v from the point, t = ±√((l − h)(l + h)).
template <int Order, class T>
DyadMotion<T, Order> close_dyad(const Rrp<T>& dyad, const T& side, BodiesBefore<T, Order> bodies) {
  using std::sqrt;
  const T& l = dyad.length;
  const auto& carrier = bodies[static_cast<std::size_t>(dyad.guide.body)];
  const auto from = motion_of<T, Order>(dyad.point, bodies);
  const Vec2<T> v = direction_of<T, Order>(dyad.guide, bodies);
  const Vec2<T> through = motion_terms::place(carrier, dyad.guide.through);
  const T h = cross(v, through - from[0]) + dyad.guide.offset;
  const T by_length = T(1) / l;

  DyadMotion<T, Order> result;
  result.closure.discriminant = ((l - h) * by_length) * ((l + h) * by_length);
  result.closure.sine = side * sqrt(result.closure.discriminant);
  result.closure.cosine = h * by_length;
  result.first.direction = Vec2<T>{result.closure.sine, result.closure.cosine} * v;
  result.first.origin = from;
  const Vec2<T> link = l * result.first.direction;
  result.second.direction = v;
  result.second.origin[0] = from[0] + link;

  if constexpr (Order >= 1) {
    const T inverse_sine = T(1) / result.closure.sine;
    const Vec2<T> arm = result.second.origin[0] - carrier.origin[0];
    motion_terms::Sliding<T, Order> slide{v, {}};
    result.second.turn = carrier.turn;
    motion_terms::for_each_order<Order>([&](auto order) {
      constexpr int kOrder = order();
      const Vec2<T> right = motion_terms::carried<kOrder>(carrier, arm) +
                            motion_terms::slid_below<kOrder>(carrier, slide) - from[kOrder] -
                            motion_terms::turned_below<kOrder>(result.first, link);
      result.first.turn[kOrder - 1] = by_length * inverse_sine * cross(v, right);
      slide.rate[kOrder - 1] = -inverse_sine * dot(right, result.first.direction);
      result.second.origin[kOrder] =
          from[kOrder] + motion_terms::turned<kOrder>(result.first, link);
    });
  }
  return result;
}

/// A line through a point at a distance from another. With d from the pivot to the block, o the
/// offset and s = ±√(d² − o²), the bar points along d/(s + i o).
template <int Order, class T>
DyadMotion<T, Order> close_dyad(const Rpr<T>& dyad, const T& side, BodiesBefore<T, Order> bodies) {
  using std::sqrt;
  const T& o = dyad.offset;
  const auto block = motion_of<T, Order>(dyad.block, bodies);
  const auto pivot = motion_of<T, Order>(dyad.pivot, bodies);
  const Vec2<T> d = block[0] - pivot[0];
  const T by_distance = T(1) / sqrt(squared_norm(d));

  DyadMotion<T, Order> result;
  result.closure.discriminant = (d.x - o) * (d.x + o) + d.y * d.y;
  const T s = side * sqrt(result.closure.discriminant);
  result.closure.sine = s * by_distance;
  result.closure.cosine = o * by_distance;
  const Vec2<T> u = Vec2<T>{result.closure.sine, -result.closure.cosine} * (by_distance * d);
  result.first.direction = u;
  result.first.origin = block;
  result.second.direction = u;
  result.second.origin = pivot;

  if constexpr (Order >= 1) {
    const T inverse = T(1) / s;
    BodyMotion<T, Order>& bar = result.second;
    motion_terms::Sliding<T, Order> slide{u, {}};
    motion_terms::for_each_order<Order>([&](auto order) {
      constexpr int kOrder = order();
      const Vec2<T> right = block[kOrder] - pivot[kOrder] -
                            motion_terms::turned_below<kOrder>(bar, d) -
                            motion_terms::slid_below<kOrder>(bar, slide);
      bar.turn[kOrder - 1] = inverse * cross(u, right);
      slide.rate[kOrder - 1] = dot(u, right) + o * bar.turn[kOrder - 1];
    });
    result.first.turn = bar.turn;
  }
  return result;
}

/// Line and line: with v₁ and v₂ along the guides, the pin is where they cross.
template <int Order, class T>
DyadMotion<T, Order> close_dyad(const Prp<T>& dyad, const T& /*side*/,
                                BodiesBefore<T, Order> bodies) {
  const auto& first = bodies[static_cast<std::size_t>(dyad.first.body)];
  const auto& second = bodies[static_cast<std::size_t>(dyad.second.body)];
  const Vec2<T> v1 = direction_of<T, Order>(dyad.first, bodies);
  const Vec2<T> v2 = direction_of<T, Order>(dyad.second, bodies);
  const Vec2<T> foot =
      motion_terms::place(first, dyad.first.through) + dyad.first.offset * perp(v1);
  const Vec2<T> through = motion_terms::place(second, dyad.second.through);

  DyadMotion<T, Order> result;
  result.closure.sine = cross(v1, v2);
  result.closure.cosine = dot(v1, v2);
  result.closure.discriminant = result.closure.sine * result.closure.sine;
  const T inverse = T(1) / result.closure.sine;
  // perp(v₂) × v₂ = −1: the second offset enters as it is.
  const T slide = inverse * (cross(through - foot, v2) - dyad.second.offset);
  result.first.direction = v1;
  result.second.direction = v2;
  result.first.origin[0] = foot + slide * v1;

  if constexpr (Order >= 1) {
    const Vec2<T> first_arm = result.first.origin[0] - first.origin[0];
    const Vec2<T> second_arm = result.first.origin[0] - second.origin[0];
    motion_terms::Sliding<T, Order> first_slide{v1, {}}, second_slide{v2, {}};
    motion_terms::for_each_order<Order>([&](auto order) {
      constexpr int kOrder = order();
      const Vec2<T> on_first = motion_terms::carried<kOrder>(first, first_arm);
      const Vec2<T> right = motion_terms::carried<kOrder>(second, second_arm) - on_first +
                            motion_terms::slid_below<kOrder>(second, second_slide) -
                            motion_terms::slid_below<kOrder>(first, first_slide);
      first_slide.rate[kOrder - 1] = inverse * cross(right, v2);
      second_slide.rate[kOrder - 1] = inverse * cross(right, v1);
      result.first.origin[kOrder] = on_first + motion_terms::slid<kOrder>(first, first_slide);
    });
    result.first.turn = first.turn;
    result.second.turn = second.turn;
  }
  result.second.origin = result.first.origin;
  return result;
}

/// Two slides in a row. With v along the guide and w = v·slot along the slot, the point is at
/// s v + t w from the guide's foot: t is its distance from the guide over v × w.
template <int Order, class T>
DyadMotion<T, Order> close_dyad(const Rpp<T>& dyad, const T& /*side*/,
                                BodiesBefore<T, Order> bodies) {
  const auto& carrier = bodies[static_cast<std::size_t>(dyad.guide.body)];
  const auto point = motion_of<T, Order>(dyad.point, bodies);
  const Vec2<T> v = direction_of<T, Order>(dyad.guide, bodies);
  const Vec2<T> w = v * dyad.slot;
  const Vec2<T> through = motion_terms::place(carrier, dyad.guide.through);

  DyadMotion<T, Order> result;
  result.closure.sine = dyad.slot.y;
  result.closure.cosine = dyad.slot.x;
  result.closure.discriminant = result.closure.sine * result.closure.sine;
  const T inverse = T(1) / result.closure.sine;
  const T along_slot = inverse * (cross(v, point[0] - through) - dyad.guide.offset);
  result.first.direction = w;
  result.first.origin = point;
  result.second.direction = v;
  result.second.origin[0] = point[0] - along_slot * w;

  if constexpr (Order >= 1) {
    const Vec2<T> point_arm = point[0] - carrier.origin[0];
    const Vec2<T> origin_arm = result.second.origin[0] - carrier.origin[0];
    motion_terms::Sliding<T, Order> guide_slide{v, {}}, slot_slide{w, {}};
    motion_terms::for_each_order<Order>([&](auto order) {
      constexpr int kOrder = order();
      const Vec2<T> right = point[kOrder] - motion_terms::carried<kOrder>(carrier, point_arm) -
                            motion_terms::slid_below<kOrder>(carrier, guide_slide) -
                            motion_terms::slid_below<kOrder>(carrier, slot_slide);
      guide_slide.rate[kOrder - 1] = inverse * cross(right, w);
      slot_slide.rate[kOrder - 1] = inverse * cross(v, right);
      result.second.origin[kOrder] = motion_terms::carried<kOrder>(carrier, origin_arm) +
                                     motion_terms::slid<kOrder>(carrier, guide_slide);
    });
    result.first.turn = carrier.turn;
    result.second.turn = carrier.turn;
  }
  return result;
}

}  // namespace cognate
