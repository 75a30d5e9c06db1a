/// @file A vector of the plane over any number type.
#pragma once

#include <cmath>

namespace cognate {

/// A point or vector of the plane; where two are multiplied, the complex number x + iy.
/// Directions are unit vectors, so rotating is multiplying and no angle is needed.
template <class T>
struct Vec2 {
  T x{};
  T y{};

  /// Sums and multiples of vectors, products of complex numbers.
  friend constexpr Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(const Vec2& a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(const T& k, const Vec2& a) { return {k * a.x, k * a.y}; }
  friend constexpr Vec2 operator*(const Vec2& a, const Vec2& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
  }
};

/// The plane in double.
using Vec2d = Vec2<double>;

/// Whether both coordinates are the same.
constexpr bool operator==(const Vec2d& a, const Vec2d& b) {
  return a.x == b.x && a.y == b.y;
}

/// a · b.
template <class T>
constexpr T dot(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.x + a.y * b.y;
}

/// The component of a × b out of the plane: positive when b lies counter-clockwise of a.
template <class T>
constexpr T cross(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.y - a.y * b.x;
}

/// The complex conjugate: the mirror image in the x axis.
template <class T>
constexpr Vec2<T> conj(const Vec2<T>& a) {
  return {a.x, -a.y};
}

/// i·a: a turned counter-clockwise by a right angle.
template <class T>
constexpr Vec2<T> perp(const Vec2<T>& a) {
  return {-a.y, a.x};
}

/// |a|².
template <class T>
constexpr T squared_norm(const Vec2<T>& a) {
  return dot(a, a);
}

/// |a|, for lengths of any size.
inline double norm(const Vec2d& a) {
  return std::hypot(a.x, a.y);
}

/// |x| + |y|.
inline double norm1(const Vec2d& a) {
  return std::abs(a.x) + std::abs(a.y);
}

/// Whether both coordinates are finite numbers.
inline bool is_finite(const Vec2d& a) {
  return std::isfinite(a.x) && std::isfinite(a.y);
}

}  // namespace cognate
