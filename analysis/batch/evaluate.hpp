// What a design does at a crank position, in as many lanes as the number type T has. The set of
// requested quantities is a template argument; what is not in it is not computed.
//
// Vectors are in the plane's axes. With t = D − B, the links are BC = N·t and DC = (N − 1)·t, N
// being HalfClosure's ratio; with G = 2/h the derivatives of the closure are
//
//     φ′ = −G AB×DC,   ψ′ = −G AB×BC,   φ″ = G (AB·DC + φ′² BC·DC − ψ′² l₃²),
//     ∂φ/∂l₁ = −G AB·DC/l₁,  ∂φ/∂l₂ = −G BC·DC/l₂,  ∂φ/∂l₃ = G l₃,  ∂φ/∂l₄ = G f·DC,
//
// φ and ψ being the angles of coupler and rocker from the frame line of direction f, h/2 = BC×DC.
#pragma once

#include "analysis/batch/design.hpp"
#include "analysis/batch/quantities.hpp"
#include "analysis/batch/roots.hpp"

namespace cognate::batch::COGNATE_ISA {

constexpr bool has(unsigned set, unsigned any_of) {
  return (set & any_of) != 0;
}

/// A design on one side of its circle: AB = pin·(1 − w) + across·s, DB likewise.
template <class T>
struct HalfDesign {
  HalfClosure<T> closure;
  Vec2<T> pin;     ///< AB at θ = 0 or π
  Vec2<T> across;  ///< AB at θ = π/2
  Vec2<T> base;    ///< D − B at θ = 0 or π
  T inverse_crank;

  HalfDesign(const Design<T>& design, int side)
      : closure(side > 0 ? design.near : design.far),
        pin(closure.signed_crank() * design.axis),
        across(closure.crank() * perp(design.axis)),
        base(closure.alpha() * design.axis),
        inverse_crank(T(1) / design.crank) {}
};

/// The closure's triangle with its roots; h/2 has the sign of the assembly.
template <class T>
struct Triangle {
  ClosureTriangle<T> sides;
  T half_root, inverse, inverse_root;

  template <bool kInverseRoot>
  Triangle(const HalfClosure<T>& closure, const T& versine, const T& half_assembly,
           std::bool_constant<kInverseRoot>)
      : sides(closure.triangle(versine)) {
    const Roots<T> found = roots<kInverseRoot>(sides.p * sides.q, sides.d2);
    half_root = half_assembly * found.root;
    inverse = found.inverse;
    inverse_root = found.inverse_root;
  }

  ClosureRatios<T> ratios() const { return HalfClosure<T>::ratios(sides, inverse, half_root); }
};

/// The transmission angle ∠BCD by BC×DC = l₂l₃ sin μ (negative for crossed) and 4 BC·DC = q − p.
template <class T>
class Transmission {
 public:
  explicit Transmission(const Design<T>& design)
      : inverse_(T(1) / (design.coupler * design.rocker)), quarter_inverse_(T(0.25) * inverse_) {}

  template <class Write>
  void operator()(const Triangle<T>& at, const Write& write) const {
    // 0·root makes the cosine, too, no number where the linkage does not close.
    const T cosine = quarter_inverse_ * (at.sides.q - at.sides.p) + T(0) * at.half_root;
    write(column_transmission_sin, inverse_ * at.half_root);
    write(column_transmission_cos, cosine);
  }

 private:
  T inverse_, quarter_inverse_;
};

/// The position of one coupler point alone, all that can be multiplied beforehand being multiplied:
/// P = start − w·pin + s·across + N·(base + w·turned_pin − s·turned_across).
template <class T>
struct PointOnly {
  Vec2<T> start, pin, across, base, turned_pin, turned_across;

  PointOnly(const Design<T>& design, const HalfDesign<T>& half, const Vec2<T>& point) {
    const Vec2<T> turn = design.inverse_coupler * point;
    pin = design.unit * half.pin;
    across = design.unit * half.across;
    start = design.pivot_a + pin;
    base = turn * half.base;
    turned_pin = turn * half.pin;
    turned_across = turn * half.across;
  }

  template <class Write>
  void operator()(const T& sin, const T& versine, const Triangle<T>& at, const Write& write) const {
    const ClosureRatios<T> ratios = at.ratios();
    const T &nx = ratios.coupler.x, &ny = ratios.coupler.y;
    const T zx = (base.x + versine * turned_pin.x) - sin * turned_across.x;
    const T zy = (base.y + versine * turned_pin.y) - sin * turned_across.y;
    const T bx = (start.x - versine * pin.x) + sin * across.x;
    const T by = (start.y - versine * pin.y) + sin * across.y;
    write(column_x, (bx + nx * zx) - ny * zy);
    write(column_y, (by + nx * zy) + ny * zx);
  }
};

/// All links at one crank position, and how they move with the crank and with the dimensions.
template <unsigned kSet, class T>
struct LinkMotion {
  static constexpr bool kFirst = has(kSet, velocity | acceleration | curvature);
  static constexpr bool kSecond = has(kSet, acceleration | curvature);
  static constexpr bool kGradient = has(kSet, gradient);

  Vec2<T> coupler;     ///< unit vector along B→C
  Vec2<T> pin;         ///< B − A, in the unit of the given lengths
  T turn1{}, turn2{};  ///< φ′, φ″
  Vec2<T> crank;       ///< unit vector along A→B
  T by_crank{}, by_coupler{}, by_rocker{}, by_frame{};  ///< ∂φ/∂lₖ, for the given lengths

  LinkMotion(const Design<T>& design, const HalfDesign<T>& half, const T& sin, const T& versine,
             const Triangle<T>& at) {
    const Vec2<T> swing = sin * half.across;
    const Vec2<T> ab = (T(1) - versine) * half.pin + swing;
    const Vec2<T> bd = half.base + versine * half.pin - swing;
    const ClosureRatios<T> ratio = at.ratios();
    const Vec2<T> bc = ratio.coupler * bd;
    coupler = design.inverse_coupler * bc;
    pin = design.unit * ab;
    if constexpr (kFirst || kGradient) {
      const Vec2<T> dc = ratio.rocker * bd;
      const T g = (design.assembly + design.assembly) * at.inverse_root;
      const T links = T(0.25) * (at.sides.q - at.sides.p);
      if constexpr (kFirst) turn1 = -(g * cross(ab, dc));
      if constexpr (kSecond) {
        const T rocker_turn = -(g * cross(ab, bc));
        const T swung = rocker_turn * design.rocker;
        turn2 = g * (dot(ab, dc) + turn1 * turn1 * links - swung * swung);
      }
      if constexpr (kGradient) {
        const T scaled = design.scale * g;
        crank = half.inverse_crank * ab;
        by_crank = -(scaled * dot(crank, dc));
        by_coupler = -(scaled * links * design.inverse_coupler);
        by_rocker = scaled * design.rocker;
        by_frame = scaled * dot(design.axis, dc);
      }
    }
  }
};

/// The gradient of a coupler point P, `arm` being P − B: a change of the coupler's angle moves it
/// by perp(arm), and a turn of the frame line all of it about A.
template <unsigned kSet, class T, class Write>
void write_gradient(const Design<T>& design, const LinkMotion<kSet, T>& links, const Vec2<T>& arm,
                    const Write& write) {
  const auto by = [&write](DesignVariable variable, const Vec2<T>& derivative) {
    write(column_gradient_x + static_cast<std::size_t>(variable), derivative.x);
    write(column_gradient_y + static_cast<std::size_t>(variable), derivative.y);
  };
  const Vec2<T> swing = perp(arm);
  const Vec2<T> frame = links.by_frame * swing;
  const Vec2<T> turn = (design.scale * design.inverse_frame) * perp(links.pin + arm);
  const Vec2<T> d_x = design.axis.x * frame - design.axis.y * turn;
  const Vec2<T> d_y = design.axis.y * frame + design.axis.x * turn;
  by(DesignVariable::pivot_a_x, {T(1) - d_x.x, -d_x.y});
  by(DesignVariable::pivot_a_y, {-d_y.x, T(1) - d_y.y});
  by(DesignVariable::pivot_d_x, d_x);
  by(DesignVariable::pivot_d_y, d_y);
  by(DesignVariable::crank, links.crank + links.by_crank * swing);
  by(DesignVariable::coupler, links.by_coupler * swing);
  by(DesignVariable::rocker, links.by_rocker * swing);
  by(DesignVariable::point_u, links.coupler);
  by(DesignVariable::point_v, perp(links.coupler));
}

/// The columns of one coupler point.
template <unsigned kSet, class T, class Write>
void write_point(const Design<T>& design, const LinkMotion<kSet, T>& links, const Vec2<T>& point,
                 const Write& write) {
  const Vec2<T> arm = links.coupler * point;
  if constexpr (has(kSet, position)) {
    const Vec2<T> at = design.pivot_a + links.pin + arm;
    write(column_x, at.x);
    write(column_y, at.y);
  }
  if constexpr (has(kSet, velocity | acceleration | curvature)) {
    const Vec2<T> first = perp(links.pin) + links.turn1 * perp(arm);
    if constexpr (has(kSet, velocity)) {
      write(column_velocity_x, first.x);
      write(column_velocity_y, first.y);
    }
    if constexpr (has(kSet, acceleration | curvature)) {
      const T squared = links.turn1 * links.turn1;
      const Vec2<T> second = (links.turn2 * perp(arm) - squared * arm) - links.pin;
      if constexpr (has(kSet, acceleration)) {
        write(column_acceleration_x, second.x);
        write(column_acceleration_y, second.y);
      }
      if constexpr (has(kSet, curvature)) {
        const Vec2<T> v = design.scale * first;
        const T inverse_speed = lane_inverse_root(squared_norm(v));
        const T cubed = inverse_speed * inverse_speed * inverse_speed;
        write(column_curvature, design.scale * (cubed * cross(v, design.scale * second)));
      }
    }
  }
  if constexpr (has(kSet, gradient)) write_gradient(design, links, arm, write);
}

}  // namespace cognate::batch::COGNATE_ISA
