/// @file The closure of the four-bar: where the coupler and the rocker stand for a crank direction.
///
/// One template for every number type with + − · ÷ and sqrt: double, dual numbers, SIMD packs and
/// extended precision. No trigonometry; angles are measured from the directed line A→D.
///
/// With crank direction (c, s) and ε = ±1 the sign of c, let w = 1 − εc and l₁ carry the sign ε:
///
///     d² = (l₄ − l₁)² + 2 l₁ l₄ w,   p = d² − (l₂ − l₃)²,   q = (l₂ + l₃)² − d²,
///     m = d² + l₂² − l₃²,            h = σ √(p q),
///     C − B = (m + i h)/(2 d²) · (D − B).
///
/// The constant parts of p and q are products of sums of lengths, so no difference of rounded
/// squares occurs and no digits are lost near limit positions and change points. Those of d² and m
/// are rounded once. Measured: `closure_accuracy` in tests/stress.
#pragma once

#include <cmath>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/compensated.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// Direction of the crank from A→D: (cos θ, sin θ), and w = 1 − |cos θ| computed without
/// cancellation. `side` is the sign of cos θ, +1 at zero.
template <class T>
struct CrankDirection {
  T cos{};
  T sin{};
  T versine{};
  int side = 1;
};

/// The direction whose half angle has the direction of `half`, a vector of length one within
/// rounding. What it lacks or exceeds in length is taken out, so that sine and versine are those of
/// one angle and rounded once.
template <class T>
constexpr CrankDirection<T> crank_direction(const Vec2<T>& half) {
  const TwoParts<T> x{half.x, T(0)}, y{half.y, T(0)};
  const TwoParts<T> xx = product(x, x), yy = product(y, y), xy = product(x, y);
  const int side = xx.high < yy.high ? -1 : 1;
  const TwoParts<T>&larger = side > 0 ? xx : yy, &smaller = side > 0 ? yy : xx;
  const T excess = ((larger.high - T(1)) + smaller.high) + (larger.low + smaller.low);
  const T versine = T(2) * (smaller.high + (smaller.low - excess * smaller.high));
  const T sine = T(2) * (xy.high + (xy.low - excess * xy.high));
  return {T(side) * (T(1) - versine), sine, versine, side};
}

/// The direction at angle `theta` in radians.
template <class T>
CrankDirection<T> crank_direction(const T& theta) {
  using std::cos;
  using std::sin;
  const T half = T(0.5) * theta;
  return crank_direction(Vec2<T>{cos(half), sin(half)});
}

/// Unit vectors along B→C and D→C in the frame's axes (x along A→D), and p·q: negative where the
/// linkage does not close (the vectors are then not numbers).
template <class T>
struct LinkDirections {
  Vec2<T> coupler;
  Vec2<T> rocker;
  T discriminant{};
};

/// The triangle B–C–D by the square of its side B–D: d², p, q and m of the formulas above, and
/// n = m − 2 d². 4 l₂ l₃ = p + q, and q − p = 4 l₂ l₃ cos ∠BCD.
template <class T>
struct ClosureTriangle {
  T d2{};
  T p{};
  T q{};
  T half_m{};
  T half_n{};
};

/// (C − B)/(D − B) and (C − D)/(D − B) as complex numbers.
template <class T>
struct ClosureRatios {
  Vec2<T> coupler;
  Vec2<T> rocker;
};

/// The constants of one design for the half circle where cos θ has the sign `side`. Lengths are
/// taken as they are: keep their fourth powers within the range of T.
template <class T>
class HalfClosure {
 public:
  HalfClosure() = default;

  /// `frame_low`: what |D − A| exceeds `links.frame` by, where it is known beyond rounding.
  HalfClosure(const Lengths<T>& links, int side, const T& frame_low = T(0))
      : crank_(links.crank), signed_crank_(side > 0 ? links.crank : T(-links.crank)) {
    const T& l1 = signed_crank_;
    const T& l2 = links.coupler;
    const T& l3 = links.rocker;
    const T& l4 = links.frame;
    const TwoParts<T> alpha = two_part_sum(l4, T(-l1), frame_low);
    const TwoParts<T> sum = two_part_sum(l2, l3), difference = two_part_sum(l2, T(-l3));
    const TwoParts<T> square = product(alpha, alpha), squares = product(difference, sum);
    alpha_ = alpha.high + alpha.low;
    square_ = square.high + square.low;
    half_m0_ = T(0.5) * rounded_sum(squares, square);
    half_n0_ = T(0.5) * rounded_sum(squares, -square);
    p0_ = rounded_sum(alpha, -difference) * rounded_sum(alpha, difference);
    q0_ = rounded_sum(sum, -alpha) * rounded_sum(sum, alpha);
    slope_ = T(2) * l1 * l4;
    inverse_coupler_ = T(1) / l2;
    inverse_rocker_ = T(1) / l3;
  }

  /// The constants of `other` in another number type: rounded, or the same in every SIMD lane.
  template <class U>
  explicit HalfClosure(const HalfClosure<U>& other)
      : crank_(other.crank_),
        signed_crank_(other.signed_crank_),
        alpha_(other.alpha_),
        p0_(other.p0_),
        q0_(other.q0_),
        square_(other.square_),
        half_m0_(other.half_m0_),
        half_n0_(other.half_n0_),
        slope_(other.slope_),
        inverse_coupler_(other.inverse_coupler_),
        inverse_rocker_(other.inverse_rocker_) {}

  /// The triangle B–C–D for a crank direction of this half circle.
  ClosureTriangle<T> triangle(const T& versine) const {
    const T kw = slope_ * versine;
    const T half_kw = T(0.5) * kw;
    return {square_ + kw, p0_ + kw, q0_ - kw, half_m0_ + half_kw, half_n0_ - half_kw};
  }

  /// `inverse` = 1/d², `half_root` = h/2.
  static ClosureRatios<T> ratios(const ClosureTriangle<T>& side, const T& inverse,
                                 const T& half_root) {
    const T across = half_root * inverse;
    return {{side.half_m * inverse, across}, {side.half_n * inverse, across}};
  }

  /// D − B in the frame's axes is (alpha + signed_crank·w, −crank·sin θ).
  const T& alpha() const { return alpha_; }
  const T& signed_crank() const { return signed_crank_; }
  const T& crank() const { return crank_; }

  /// Where the links point; `assembly` is +1 (open) or −1 (crossed).
  LinkDirections<T> at(const T& sin, const T& versine, const T& assembly) const {
    using std::sqrt;
    const ClosureTriangle<T> side = triangle(versine);
    const T discriminant = side.p * side.q;
    const ClosureRatios<T> ratio =
        ratios(side, T(1) / side.d2, T(0.5) * assembly * sqrt(discriminant));
    const Vec2<T> diagonal{alpha_ + signed_crank_ * versine, -crank_ * sin};
    return {inverse_coupler_ * (ratio.coupler * diagonal),
            inverse_rocker_ * (ratio.rocker * diagonal), discriminant};
  }

 private:
  template <class U>
  friend class HalfClosure;

  T crank_{}, signed_crank_{}, alpha_{}, p0_{}, q0_{}, square_{}, half_m0_{}, half_n0_{}, slope_{};
  T inverse_coupler_{}, inverse_rocker_{};
};

/// The closure over the whole circle, for number types that can branch on a sign.
template <class T>
class Closure {
 public:
  Closure() = default;
  /// `frame_low`: as of HalfClosure.
  explicit Closure(const Lengths<T>& links, const T& frame_low = T(0))
      : near_(links, +1, frame_low), far_(links, -1, frame_low) {}

  /// Where coupler and rocker point; `assembly` is +1 (open) or −1 (crossed).
  LinkDirections<T> at(const CrankDirection<T>& crank, const T& assembly) const {
    return (crank.side > 0 ? near_ : far_).at(crank.sin, crank.versine, assembly);
  }

 private:
  HalfClosure<T> near_, far_;
};

/// Derivatives of the angles of coupler (φ) and rocker (ψ) with respect to the four lengths and the
/// crank angle, from the closure l₁e₁ + l₂e₂ = l₄ + l₃e₃ projected on e₃ and e₂. Infinite at dead
/// points (e₂ parallel to e₃).
template <class T>
struct AngleGradient {
  T crank{}, coupler{}, rocker{}, frame{}, crank_angle{};
};

/// The gradients of both angles.
template <class T>
struct ClosureGradient {
  AngleGradient<T> coupler;
  AngleGradient<T> rocker;
};

/// The gradients where the links point along `at`, the crank along `crank` (frame axes).
template <class T>
ClosureGradient<T> closure_gradient(const Lengths<T>& links, const Vec2<T>& crank,
                                    const LinkDirections<T>& at) {
  const Vec2<T>&e2 = at.coupler, &e3 = at.rocker;
  const T sine = cross(e2, e3);
  const T along = dot(e2, e3);
  const T by_coupler = T(1) / (links.coupler * sine);
  const T by_rocker = T(-1) / (links.rocker * sine);
  const Vec2<T> turn = links.crank * perp(crank);
  return {{-by_coupler * dot(crank, e3), -by_coupler * along, by_coupler, by_coupler * e3.x,
           -by_coupler * dot(turn, e3)},
          {by_rocker * dot(crank, e2), by_rocker, -by_rocker * along, -by_rocker * e2.x,
           by_rocker * dot(turn, e2)}};
}

}  // namespace cognate
