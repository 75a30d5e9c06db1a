#include "analysis/coupler_curve/circuits.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/half_angle.hpp"

namespace cognate {
namespace {

/// The share of a range, from either end, that goes by the transmission angle.
constexpr double kEndShare = 0.2;

Vec2d normalised(const Vec2d& v) {
  constexpr double kSmall = 1e-280;  // below it the square loses digits
  const double square = squared_norm(v);
  const double length = square > kSmall ? std::sqrt(square) : std::hypot(v.x, v.y);
  return length > 0 ? (1 / length) * v : Vec2d{1, 0};
}

/// The unit vector whose half angle has the tangent √(opposite/adjacent), above or below the axis.
Vec2d from_half(double opposite, double adjacent, double sign) {
  const Vec2d half =
      normalised({std::sqrt(std::max(adjacent, 0.0)), sign * std::sqrt(std::max(opposite, 0.0))});
  return half * half;
}

/// From D − B = l₂e₂ − l₃e₃ and e₃ = e₂·`transmission`.
LinkPose close(const Lengths<double>& links, const Vec2d& crank, const Vec2d& diagonal,
               const Vec2d& transmission) {
  const Vec2d side = Vec2d{links.coupler, 0} - links.rocker * transmission;
  const Vec2d coupler = normalised(diagonal * conj(side));
  return {crank, coupler, coupler * transmission};
}

}  // namespace

Circuits::Circuits(const Lengths<double>& links)
    : links_(links), near_(links, +1), far_(links, -1) {
  const auto ranges = crank_ranges(links);
  if (crank_rotates(links)) {
    // Off the frame's direction, where symmetric curves have what is looked for.
    constexpr double start = -0.1;
    arcs_ = {{CircuitArc::By::crank, start, start + kTurn, +1, 0},
             {CircuitArc::By::crank, start, start + kTurn, -1, 1}};
    return;
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    add_range(ranges[i].from, ranges[i].to, static_cast<int>(i));
  }
}

void Circuits::keep(int circuit) {
  std::erase_if(arcs_, [circuit](const CircuitArc& arc) { return arc.circuit != circuit; });
}

void Circuits::add_range(double from, double to, int circuit) {
  const double share = kEndShare * (to - from);
  const double first = from + share, last = to - share;
  const auto turn_back = [&](double end, double inside) {
    const auto [d2, p, q, half_m, half_n] = triangle(end);
    const auto there = triangle(inside);
    const double angle = angle_of_half(there.p, there.q);
    const double sign = std::sin(0.5 * (end + inside)) < 0 ? -1 : 1;
    // From one assembly to the other through μ = 0 or π.
    const bool folded = p < q;
    const double from_angle = folded ? -angle : angle, to_angle = folded ? angle : kTurn - angle;
    arcs_.push_back({CircuitArc::By::transmission, from_angle, to_angle, sign, circuit});
  };
  arcs_.push_back({CircuitArc::By::crank, first, last, +1, circuit});
  turn_back(to, last);
  arcs_.push_back({CircuitArc::By::crank, first, last, -1, circuit});
  turn_back(from, first);
}

ClosureTriangle<double> Circuits::triangle(double crank_angle) const {
  const auto crank = crank_direction(crank_angle);
  return (crank.side > 0 ? near_ : far_).triangle(crank.versine);
}

LinkPose Circuits::at(const CircuitArc& arc, double place) const {
  return arc.by == CircuitArc::By::crank ? by_crank(place, arc.sign)
                                         : by_transmission(place, arc.sign);
}

LinkPose Circuits::by_crank(double crank_angle, double side) const {
  const auto crank = crank_direction(crank_angle);
  const HalfClosure<double>& half = crank.side > 0 ? near_ : far_;
  const auto triangle = half.triangle(crank.versine);
  const Vec2d diagonal{half.alpha() + half.signed_crank() * crank.versine,
                       -half.crank() * crank.sin};
  return close(links_, {crank.cos, crank.sin}, diagonal, from_half(triangle.p, triangle.q, side));
}

LinkPose Circuits::by_transmission(double angle, double sign) const {
  const auto [l1, l2, l3, l4] = links_;
  // opposite = d² − (l₄ − l₁)², adjacent = (l₄ + l₁)² − d², from the flat triangle that is nearer.
  const auto transmission = crank_direction(angle);
  const double change = 2 * l2 * l3 * transmission.versine;
  const double folded = transmission.side > 0 ? -l3 : l3;  // B–D = l₂ + this, at μ = 0 or π
  const double grown = transmission.side > 0 ? change : -change;
  const double opposite =
      compensated_sum(l2, folded, -l4, l1) * compensated_sum(l2, folded, l4, -l1) + grown;
  const double adjacent =
      compensated_sum(l4, l1, -l2, -folded) * compensated_sum(l4, l1, l2, folded) - grown;
  const Vec2d crank = from_half(opposite, adjacent, sign);
  const Vec2d diagonal = Vec2d{l4, 0} - l1 * crank;
  return close(links_, crank, diagonal, unit_vector(angle));
}

BodyMotion<double, 3> coupler_motion(const Lengths<double>& links, const LinkPose& pose) {
  const auto& [e1, e2, e3] = pose;
  const double s23 = cross(e2, e3), s31 = cross(e3, e1), s12 = cross(e1, e2);
  const double c23 = dot(e2, e3), c31 = dot(e3, e1), c12 = dot(e1, e2);
  // Rates of the angles θ, φ, ψ of e₁, e₂, e₃, and their derivatives.
  const double a = s23 / links.crank, b = s31 / links.coupler, c = -s12 / links.rocker;
  const double a1 = c23 * (c - b) / links.crank;
  const double b1 = c31 * (a - c) / links.coupler;
  const double c1 = -c12 * (b - a) / links.rocker;
  const double a2 = (c23 * (c1 - b1) - s23 * (c - b) * (c - b)) / links.crank;
  const double b2 = (c31 * (a1 - c1) - s31 * (a - c) * (a - c)) / links.coupler;
  const Vec2d pin = links.crank * e1;
  return {
      e2,
      {pin, Vec2d{0, a} * pin, Vec2d{-a * a, a1} * pin, Vec2d{-3 * a * a1, a2 - a * a * a} * pin},
      {b, b1, b2}};
}

}  // namespace cognate
