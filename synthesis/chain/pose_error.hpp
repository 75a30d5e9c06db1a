/// @file How far a point and the body that carries it are from a pose, as a vector of three: the
/// distances along x and y, and the chord of the angle between the directions times a length. A
/// chord is the angle to its third power and has no jump where a body stands upside down.
#pragma once

#include <cmath>

#include "analysis/numbers/vec2.hpp"

namespace cognate::synthesis {

/// Two lengths and an angle times a length.
template <class T>
struct PoseVector {
  T x, y, turn;
};

template <class T>
PoseVector<T> operator*(const T& share, const PoseVector<T>& v) {
  return {share * v.x, share * v.y, share * v.turn};
}

template <class T>
T dot(const PoseVector<T>& a, const PoseVector<T>& b) {
  return a.x * b.x + a.y * b.y + a.turn * b.turn;
}

/// 2 sin(δ/2), δ the angle from `wanted` to `reached`, and its derivative by δ.
template <class T>
struct Chord {
  T length, slope;

  Chord(const Vec2<T>& wanted, const Vec2<T>& reached) {
    using std::sqrt;
    constexpr double kUpsideDown = 1e-12;  // the squared cosine of δ/2 that counts as none
    const T square = T(0.5) * (T(1) + dot(wanted, reached)) + T(kUpsideDown);
    slope = sqrt(square);
    length = cross(wanted, reached) / slope;
  }
};

/// Two unit vectors that are perpendicular to the unit vector `n` and to each other (Duff et al.
/// 2017, "Building an orthonormal basis, revisited"); `sign` is 1, or −1 where n.turn is negative.
template <class T>
void across(const PoseVector<T>& n, const T& sign, PoseVector<T>& first, PoseVector<T>& second) {
  const T a = T(-1) / (sign + n.turn), b = n.x * n.y * a;
  first = {T(1) + sign * n.x * n.x * a, sign * b, -sign * n.x};
  second = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace cognate::synthesis
