/// @file The closure of the dyad RRR: circle and circle.
///
/// With d from the first to the second point, p = d² − (l₁ − l₂)², q = (l₁ + l₂)² − d² and
/// h = ±√(pq), the links point along (d² ± (l₁² − l₂²) + i h)/(2 d² lₖ)·d. What decides the
/// accuracy near dead points and change points is how p, q and d come about, not what follows.
#pragma once

#include <cmath>

#include "analysis/mechanism/dyad_parts.hpp"
#include "analysis/numbers/compensated.hpp"

namespace cognate {

/// The side of the triangle that the links of a dyad close, from its first to its second point.
template <class T>
struct Diagonal {
  Vec2<T> d{};
  T square{};  ///< d²
  T p{};       ///< d² − (l₁ − l₂)²
  T q{};       ///< (l₁ + l₂)² − d²
};

/// From the points as they stand.
template <class T>
Diagonal<T> diagonal(const Rrr<T>& dyad, const Vec2<T>& d) {
  const T difference = dyad.first_length - dyad.second_length;
  const T sum = dyad.first_length + dyad.second_length;
  return {d, squared_norm(d), (d.x - difference) * (d.x + difference) + d.y * d.y,
          (sum - d.x) * (sum + d.x) - d.y * d.y};
}

/// From the pin of a crank to a point of the frame, as accurate as closure.hpp: with r the crank's
/// length, g that of the frame, and the unit vectors â and ĝ along them,
///
///     p = (g − r − l₁ + l₂)(g − r + l₁ − l₂) + r g |â − ĝ|²,
///     q = (l₁ + l₂ − g + r)(l₁ + l₂ + g − r) − r g |â − ĝ|²
///       = (l₁ + l₂ − g − r)(l₁ + l₂ + g + r) + r g |â + ĝ|²,
///     d = ĝ·(g − r + ½ r |â − ĝ|² − i r ĝ × â).
///
/// The first form of q keeps its digits where the crank points to the frame's point, the second
/// where it points away; a mean of both is taken, whose weight is of second order where it is not
/// wanted, so that nothing branches.
///
/// So the error of the crank's direction acts as one of its angle, and no difference of rounded
/// squares occurs. `arm` is from the crank's pivot to the pin in the crank's axes, `frame` from
/// there to the point of the frame.
template <class T>
Diagonal<T> crank_diagonal(const Rrr<T>& dyad, const Vec2<T>& crank, const Vec2<T>& arm,
                           const Vec2<T>& frame) {
  using std::sqrt;
  // Lets a point of the frame stand on the crank's pivot; rounded away anywhere else.
  const Vec2<T> base{frame.x + T(1e-150), frame.y};
  const T r = sqrt(squared_norm(arm)), g = sqrt(squared_norm(base));
  const Vec2<T> along_frame = (T(1) / g) * base;
  const Vec2<T> along_crank = crank * ((T(1) / r) * arm);
  const T away = squared_norm(along_crank - along_frame);
  const T towards = squared_norm(along_crank + along_frame);
  const T near = r * g * away, far = r * g * towards;

  // Differences of lengths in two parts each, rounded once at the end.
  const TwoParts<T> alpha = two_part_sum(g, T(-r)), reach = two_part_sum(g, r);
  const TwoParts<T> difference = two_part_sum(dyad.first_length, T(-dyad.second_length));
  const TwoParts<T> sum = two_part_sum(dyad.first_length, dyad.second_length);
  const auto plus = [](const TwoParts<T>& a, const TwoParts<T>& b) {
    return T((a.high + b.high) + (a.low + b.low));
  };
  const auto minus = [](const TwoParts<T>& a, const TwoParts<T>& b) {
    return T((a.high - b.high) + (a.low - b.low));
  };
  // 3t² − 2t³ of t = ¼|â ± ĝ|², which add up to one.
  const T near_weight = T(0.0625) * towards * towards * (T(3) - T(0.5) * towards);
  const T far_weight = T(0.0625) * away * away * (T(3) - T(0.5) * away);
  const T near_q = minus(sum, alpha) * plus(sum, alpha) - near;
  const T far_q = minus(sum, reach) * plus(sum, reach) + far;
  const Vec2<T> d{alpha.high + T(0.5) * r * away, -r * cross(along_frame, along_crank)};
  return {d * along_frame, alpha.high * alpha.high + near,
          minus(alpha, difference) * plus(alpha, difference) + near,
          near_weight * near_q + far_weight * far_q};
}

/// The links of the dyad on points that move as `from` and `to`.
template <int Order, class T>
DyadMotion<T, Order> close_rrr(const Rrr<T>& dyad, const T& side,
                               const std::array<Vec2<T>, Order + 1>& from,
                               const std::array<Vec2<T>, Order + 1>& to,
                               const Diagonal<T>& diagonal) {
  using std::sqrt;
  const T &l1 = dyad.first_length, &l2 = dyad.second_length;
  const T by_lengths = T(0.5) / (l1 * l2);
  const T by_square = T(1) / diagonal.square;

  DyadMotion<T, Order> result;
  DyadClosure<T>& closure = result.closure;
  closure.discriminant = (diagonal.p * by_lengths) * (diagonal.q * by_lengths);
  closure.sine = side * sqrt(closure.discriminant);
  closure.cosine = T(0.5) * by_lengths * (diagonal.q - diagonal.p);
  // d² + l₁² − l₂² over 2 l₁ d², and h over 2 l₁ d²: l₂ sin μ over d².
  const T excess = (l1 - l2) * (l1 + l2) * by_square;
  const T height = closure.sine * by_square;
  const T by_first = l2 * by_lengths, by_second = l1 * by_lengths;
  const Vec2<T> e1 = Vec2<T>{by_first * (T(1) + excess), l2 * height} * diagonal.d;
  const Vec2<T> e2 = Vec2<T>{by_second * (excess - T(1)), l1 * height} * diagonal.d;
  result.first.direction = e1;
  result.second.direction = e2;
  result.first.origin = from;
  result.second.origin = to;

  if constexpr (Order >= 1) {
    const T inverse_sine = T(1) / closure.sine;
    const T first_factor = T(2) * by_first * inverse_sine;    // 1/(l₁ sin μ)
    const T second_factor = T(2) * by_second * inverse_sine;  // 1/(l₂ sin μ)
    motion_terms::for_each_order<Order>([&](auto order) {
      constexpr int kOrder = order();
      const Vec2<T> right = to[kOrder] - from[kOrder] +
                            motion_terms::turned_below<kOrder>(result.second, l2 * e2) -
                            motion_terms::turned_below<kOrder>(result.first, l1 * e1);
      result.first.turn[kOrder - 1] = first_factor * dot(right, e2);
      result.second.turn[kOrder - 1] = second_factor * dot(right, e1);
    });
  }
  return result;
}

/// The dyad on any two points.
template <int Order, class T>
DyadMotion<T, Order> close_dyad(const Rrr<T>& dyad, const T& side, BodiesBefore<T, Order> bodies) {
  const auto from = motion_of<T, Order>(dyad.first, bodies);
  const auto to = motion_of<T, Order>(dyad.second, bodies);
  return close_rrr<Order>(dyad, side, from, to, diagonal(dyad, to[0] - from[0]));
}

/// The dyad of a four-bar: on a point of the driving crank (body 1) and one of the frame.
template <int Order, class T>
DyadMotion<T, Order> close_on_crank(const Rrr<T>& dyad, const T& side,
                                    BodiesBefore<T, Order> bodies) {
  const bool crank_first = dyad.first.body == 1;
  const Attached<T>&pin = crank_first ? dyad.first : dyad.second,
        &pivot = crank_first ? dyad.second : dyad.first;
  const BodyMotion<T, Order>& crank = bodies[1];
  Diagonal<T> diagonal = crank_diagonal(dyad, crank.direction, pin.at, pivot.at - crank.origin[0]);
  if (!crank_first) diagonal.d = -diagonal.d;
  return close_rrr<Order>(dyad, side, motion_of<T, Order>(dyad.first, bodies),
                          motion_of<T, Order>(dyad.second, bodies), diagonal);
}

}  // namespace cognate
