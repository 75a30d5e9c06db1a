/// @file The terms of differentiated closures: turning and sliding vectors, by Leibniz' rule.
///
/// A vector r that turns with the derivatives f′, f″, f‴ of its angle has
///
///     r′ = i f′ r,   r″ = (i f″ − f′²) r,   r‴ = (i f‴ − 3 f′ f″ − i f′³) r.
///
/// The highest derivative of the angle enters linearly, with the same factor i r in every order;
/// all else is known from the orders below. So each closure has one matrix for all orders.
#pragma once

#include <type_traits>
#include <utility>

#include "analysis/mechanism/mechanism.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate::motion_terms {

/// Calls `solve(std::integral_constant<int, K>)` for K = 1…Order.
template <int Order, class Solve>
void for_each_order(Solve&& solve) {
  [&]<int... K>(std::integer_sequence<int, K...>) {
    (solve(std::integral_constant<int, K + 1>{}), ...);
  }
  (std::make_integer_sequence<int, Order>{});
}

/// What the orders below K leave in dᴷr/dqᴷ of a turning vector `r`.
template <int K, class T, int Order>
Vec2<T> turned_below(const BodyMotion<T, Order>& body, const Vec2<T>& r) {
  static_assert(1 <= K && K <= 3);
  if constexpr (K == 1) return {T(0), T(0)};
  if constexpr (K == 2) return -(body.turn[0] * body.turn[0]) * r;
  if constexpr (K == 3) {
    const T& first = body.turn[0];
    return -(T(3) * first * body.turn[1]) * r - (first * first * first) * perp(r);
  }
}

/// dᴷr/dqᴷ of a vector `r` fixed on `body`.
template <int K, class T, int Order>
Vec2<T> turned(const BodyMotion<T, Order>& body, const Vec2<T>& r) {
  return body.turn[K - 1] * perp(r) + turned_below<K>(body, r);
}

/// dᴷ/dqᴷ of the point of `body` that stands `r` from its origin, in global axes.
template <int K, class T, int Order>
Vec2<T> carried(const BodyMotion<T, Order>& body, const Vec2<T>& r) {
  return body.origin[K] + turned<K>(body, r);
}

/// A displacement along the unit vector `along` fixed on a turning `body`: dᵏs/dqᵏ, k = 1…Order,
/// at [k − 1].
template <class T, int Order>
struct Sliding {
  Vec2<T> along{};
  std::array<T, Order == 0 ? 1 : Order> rate{};
};

/// What the orders below K leave of the sliding in dᴷ(s·along)/dqᴷ, s itself taken as fixed (what
/// is due to that is in `carried`).
template <int K, class T, int Order>
Vec2<T> slid_below(const BodyMotion<T, Order>& body, const Sliding<T, Order>& slide) {
  static_assert(1 <= K && K <= 3);
  if constexpr (K == 1) return {T(0), T(0)};
  if constexpr (K == 2) return (T(2) * slide.rate[0]) * turned<1>(body, slide.along);
  if constexpr (K == 3) {
    return T(3) * (slide.rate[0] * turned<2>(body, slide.along) +
                   slide.rate[1] * turned<1>(body, slide.along));
  }
}

/// The part of dᴷ(s·along)/dqᴷ that is due to sliding.
template <int K, class T, int Order>
Vec2<T> slid(const BodyMotion<T, Order>& body, const Sliding<T, Order>& slide) {
  return slide.rate[K - 1] * slide.along + slid_below<K>(body, slide);
}

/// A point's place alone.
template <class T, int Order>
Vec2<T> place(const BodyMotion<T, Order>& body, const Vec2<T>& at) {
  return body.origin[0] + body.direction * at;
}

}  // namespace cognate::motion_terms
