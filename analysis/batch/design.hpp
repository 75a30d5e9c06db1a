/// @file What of a four-bar design is computed once for all crank positions.
///
/// Templates on the number type: double for one design, SIMD packs for one design in each lane.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "analysis/linkage/closure.hpp"
#include "analysis/numbers/long_length.hpp"

namespace cognate::batch {

/// The dimensions of a four-bar but for the coupler point.
template <class T>
struct Dimensions {
  Vec2<T> pivot_a, pivot_d;
  T crank{}, coupler{}, rocker{};
  T assembly{};  ///< +1 open, −1 crossed
};

/// The greatest power of two not above `x` (positive and normal).
inline double power_of_two_below(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000);
}

/// 1/x, x being a power of two.
inline double inverse_of_power(double x) {
  return 1 / x;
}

/// A design prepared. Lengths are in units of `unit`, a power of two near the largest, so that no
/// product of theirs overflows or vanishes; `pivot_a` is as it was given.
template <class T>
struct Design {
  HalfClosure<T> near, far;  ///< for cos θ ≥ 0 and cos θ < 0
  Vec2<T> pivot_a;
  Vec2<T> axis;  ///< unit vector from A to D
  T crank{}, coupler{}, rocker{}, frame{};
  T inverse_coupler{}, inverse_frame{};
  T assembly{};
  T unit{}, scale{};  ///< scale = 1/unit

  Design() = default;

  explicit Design(const Dimensions<T>& given) : pivot_a(given.pivot_a), assembly(given.assembly) {
    using std::abs;
    using std::max;
    const Vec2<T> base = given.pivot_d - given.pivot_a;
    unit = power_of_two_below(
        max(max(max(abs(base.x), abs(base.y)), given.crank), max(given.coupler, given.rocker)));
    scale = inverse_of_power(unit);
    const Vec2<T> base_low{difference_error(given.pivot_d.x, given.pivot_a.x, base.x),
                           difference_error(given.pivot_d.y, given.pivot_a.y, base.y)};
    const LongLength<T> length = long_length(scale * base, scale * base_low);
    crank = scale * given.crank;
    coupler = scale * given.coupler;
    rocker = scale * given.rocker;
    frame = length.high;
    inverse_coupler = T(1) / coupler;
    inverse_frame = length.inverse;
    axis = (scale * inverse_frame) * base;
    const Lengths<T> links{crank, coupler, rocker, frame};
    near = HalfClosure<T>(links, +1, length.low);
    far = HalfClosure<T>(links, -1, length.low);
  }

  /// The same design in another number type.
  template <class U>
  explicit Design(const Design<U>& other)
      : near(other.near),
        far(other.far),
        pivot_a{T(other.pivot_a.x), T(other.pivot_a.y)},
        axis{T(other.axis.x), T(other.axis.y)},
        crank(other.crank),
        coupler(other.coupler),
        rocker(other.rocker),
        frame(other.frame),
        inverse_coupler(other.inverse_coupler),
        inverse_frame(other.inverse_frame),
        assembly(other.assembly),
        unit(other.unit),
        scale(other.scale) {}
};

}  // namespace cognate::batch
