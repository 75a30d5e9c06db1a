/// @file A link with three pins, each held by a link from a point that moves with the crank: the
/// Assur group of class III. It closes by Newton's method, from where it stood before.
///
/// Where a holding link k is taken away, the link can move about a pole; w_k, the cross product of
/// the other two rows of the Jacobian, is that motion. Both the solution of M dx = c and that of
/// Mᵀλ = f are combinations of the three, divided by the determinant. The transmission angle of
/// link k is that between it and the path of its pin in the motion w_k, 90° where it drives best
/// (as Alt 1932 measures it between coupler and rocker); all three are 0 at dead points.
#pragma once

#include <cmath>
#include <type_traits>

#include "analysis/numbers/vec2.hpp"

namespace cognate::synthesis {

/// What of the link and of those that hold it is the same at all positions.
template <class T>
struct HeldLink {
  T length[3];    ///< of the links that hold it
  T distance;     ///< from the first pin to the second
  Vec2<T> third;  ///< the third pin, in the axes from the first towards the second
};

/// Where the link stands: its first pin, and the direction from there to the second.
template <class T>
struct HeldPlace {
  Vec2<T> first;
  Vec2<T> axis;

  void pins(const HeldLink<T>& link, Vec2<T>* out) const {
    out[0] = first;
    out[1] = first + link.distance * axis;
    out[2] = first + link.third * axis;
  }
};

/// A row of the Jacobian, or a motion of the link: of its first pin, and its rotation.
template <class T>
struct Twist {
  Vec2<T> shift;
  T turn;

  friend Twist cross(const Twist& a, const Twist& b) {
    const Vec2<T> across = b.turn * a.shift - a.turn * b.shift;
    return {{across.y, -across.x}, cross(a.shift, b.shift)};
  }
  friend T dot(const Twist& a, const Twist& b) { return dot(a.shift, b.shift) + a.turn * b.turn; }
};

/// The closure equations ½(|P_k − O_k|² − l_k²) = 0, differentiated where the link stands.
template <class T>
struct HeldClosure {
  Vec2<T> along[3];    ///< P_k − O_k
  Vec2<T> arm[3];      ///< P_k − P_1
  Twist<T> row[3];     ///< the Jacobian
  Twist<T> motion[3];  ///< w_k
  T determinant;

  HeldClosure(const Vec2<T>* held_by, const Vec2<T>* pins) {
    for (int k = 0; k < 3; ++k) {
      along[k] = pins[k] - held_by[k];
      arm[k] = pins[k] - pins[0];
      row[k] = {along[k], cross(arm[k], along[k])};
    }
    for (int k = 0; k < 3; ++k) motion[k] = cross(row[(k + 1) % 3], row[(k + 2) % 3]);
    determinant = dot(row[0], motion[0]);
  }

  /// The solution of M dx = c.
  Twist<T> solve(const T* c) const {
    const T share = T(1) / determinant;
    Twist<T> sum{{T(0), T(0)}, T(0)};
    for (int k = 0; k < 3; ++k) {
      sum.shift = sum.shift + (share * c[k]) * motion[k].shift;
      sum.turn = sum.turn + share * c[k] * motion[k].turn;
    }
    return sum;
  }

  /// The solution of Mᵀλ = f.
  void solve_transposed(const Twist<T>& f, T* lambda) const {
    const T share = T(1) / determinant;
    for (int k = 0; k < 3; ++k) lambda[k] = share * dot(f, motion[k]);
  }

  /// How pin k moves in the motion w_k.
  Vec2<T> free_motion(int k) const { return motion[k].shift + motion[k].turn * perp(arm[k]); }
};

/// One step of Newton's method; returns the square of how far it was, as a share of the lengths.
template <class T>
T close_nearer(const HeldLink<T>& link, const Vec2<T>* held_by, HeldPlace<T>& place) {
  using std::sqrt;
  Vec2<T> pins[3];
  place.pins(link, pins);
  const HeldClosure<T> closure(held_by, pins);
  T missing[3];
  for (int k = 0; k < 3; ++k) {
    missing[k] = T(0.5) * (link.length[k] * link.length[k] - squared_norm(closure.along[k]));
  }
  const Twist<T> step = closure.solve(missing);
  place.first = place.first + step.shift;
  const Vec2<T> turned = place.axis + step.turn * perp(place.axis);
  place.axis = (T(1) / sqrt(squared_norm(turned))) * turned;
  const T around = step.turn * link.distance;
  return (squared_norm(step.shift) + around * around) /
         (link.length[0] * link.length[0] + link.distance * link.distance);
}

/// The link held by the points `held_by` after it stood at `place` while they were `before`. Not a
/// number where it does not close, or not on the same side of its dead points: `side` is the
/// determinant there, and becomes that here.
template <class T>
void follow(const HeldLink<T>& link, const Vec2<T>* before, const Vec2<T>* held_by, int steps,
            int iterations, HeldPlace<T>& place, T& side) {
  using std::sqrt;
  for (int step = 1; step <= steps; ++step) {
    Vec2<T> at[3];
    const T share = T(double(step) / steps);
    for (int k = 0; k < 3; ++k) {
      at[k] = step == steps ? held_by[k] : before[k] + share * (held_by[k] - before[k]);
    }
    for (int i = 0; i < iterations; ++i) {
      const T moved = close_nearer(link, at, place);
      // The next step would be the square of this one.
      constexpr double kEnd = 1e-20;
      if constexpr (std::is_floating_point_v<T>) {
        if (moved < T(kEnd)) break;
      }
    }
  }
  Vec2<T> pins[3];
  place.pins(link, pins);
  const HeldClosure<T> closure(held_by, pins);
  T left(1);
  for (int k = 0; k < 3; ++k) {
    constexpr double kClosed = 1e-9;  // relative: Newton's method has converged, or does not
    const T square = link.length[k] * link.length[k];
    const T missing = (squared_norm(closure.along[k]) - square) / (T(kClosed) * square);
    left = left * sqrt(T(1) - missing * missing);
  }
  const T none = T(0) * (left + sqrt(side * closure.determinant));
  place.first = place.first + Vec2<T>{none, none};
  side = closure.determinant;
}

/// The cosine of the transmission angle of holding link k.
template <class T>
T transmission_cosine(const HeldLink<T>& link, const HeldClosure<T>& closure, int k) {
  using std::sqrt;
  const Vec2<T> path = closure.free_motion(k);
  return cross(closure.along[k], path) / (link.length[k] * sqrt(squared_norm(path)));
}

/// Its derivatives by the pins and by the points that hold them; returns that by the length of
/// link k. Derivation: with n the direction of the path v of pin k and D_k = P_k − O_k,
/// dc = (dD_k × n + (D_k·n)(in·dv)/|v|)/l_k, and v is a product of the rows i and j.
template <class T>
T transmission_slopes(const HeldLink<T>& link, const HeldClosure<T>& closure, int k,
                      const T& cosine, Vec2<T>* by_pins, Vec2<T>* by_holders) {
  using std::sqrt;
  const T inverse = T(1) / link.length[k];
  const Vec2<T> path = closure.free_motion(k);
  const T speed = sqrt(squared_norm(path));
  const Vec2<T> n = (T(1) / speed) * path;
  const Vec2<T> by_path = (inverse * dot(closure.along[k], n) / speed) * perp(n);
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const Twist<T> by_motion{by_path, dot(by_path, perp(closure.arm[k]))};
  const Twist<T> by_row[2] = {cross(closure.row[j], by_motion), cross(by_motion, closure.row[i])};
  for (int m = 0; m < 3; ++m) by_pins[m] = by_holders[m] = {T(0), T(0)};
  const auto add = [&](int pin, const Vec2<T>& by_along, const Vec2<T>& by_arm) {
    by_pins[pin] = by_pins[pin] + by_along + by_arm;
    by_pins[0] = by_pins[0] - by_arm;
    by_holders[pin] = by_holders[pin] - by_along;
  };
  add(k, -inverse * perp(n), -closure.motion[k].turn * perp(by_path));
  for (int m = 0; m < 2; ++m) {
    const int pin = m == 0 ? i : j;
    const auto& [shift, turn] = by_row[m];
    add(pin, shift + turn * perp(closure.arm[pin]), -turn * perp(closure.along[pin]));
  }
  return -inverse * cosine;
}

}  // namespace cognate::synthesis
