#include "tests/stress/closure_forms.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::stress {
namespace {

/// B→D for the crank at (cos θ, sin θ), as the common formulas begin.
struct Diagonal {
  Vec2d crank, bd;
  double square;
};

Diagonal diagonal(const Configuration& at) {
  const Vec2d crank = rounded_crank(at.half_crank);
  const Vec2d bd = Vec2d{at.links.frame, 0} - at.links.crank * crank;
  return {crank, bd, squared_norm(bd)};
}

/// From the coupler's direction, as those formulas end: (C − D)/l₃.
Answer with_rocker(const Configuration& at, const Diagonal& d, const Vec2d& coupler) {
  if (!std::isfinite(coupler.x) || !std::isfinite(coupler.y)) return {};
  const Vec2d dc = at.links.coupler * coupler - d.bd;
  return {true, coupler, (1 / at.links.rocker) * dc};
}

Vec2d unit(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// The angle from a·t² + b·t + c = 0 in t = tan(angle/2), the root with `sign`.
double angle_of_tangent(double a, double b, double c, double sign) {
  return 2 * std::atan2(-b + sign * std::sqrt(b * b - 4 * a * c), 2 * a);
}

}  // namespace

Answer kernel(const Configuration& at) {
  const auto links = Closure<double>(at.links).at(crank_direction(at.half_crank), at.assembly);
  if (!(links.discriminant >= 0) || !std::isfinite(links.coupler.x)) return {};
  return {true, links.coupler, links.rocker};
}

Answer law_of_cosines(const Configuration& at) {
  const double l2 = at.links.coupler, l3 = at.links.rocker;
  const Diagonal d = diagonal(at);
  const double length = std::sqrt(d.square);
  const double at_b = std::acos((l2 * l2 + length * length - l3 * l3) / (2 * l2 * length));
  const double at_d = std::acos((l3 * l3 + length * length - l2 * l2) / (2 * l3 * length));
  const double bd = std::atan2(d.bd.y, d.bd.x);
  if (!std::isfinite(at_b) || !std::isfinite(at_d)) return {};
  return {true, unit(bd + at.assembly * at_b), -unit(bd - at.assembly * at_d)};
}

Answer half_angle_tangents(const Configuration& at) {
  const auto& [l1, l2, l3, l4] = at.links;
  const auto [cosine, sine] = rounded_crank(at.half_crank);
  const double k1 = l4 / l1, k2 = l4 / l3, k4 = l4 / l2;
  const double k3 = (l1 * l1 - l2 * l2 + l3 * l3 + l4 * l4) / (2 * l1 * l3);
  const double k5 = (l3 * l3 - l4 * l4 - l1 * l1 - l2 * l2) / (2 * l1 * l2);
  const double rocker = angle_of_tangent(cosine - k1 - k2 * cosine + k3, -2 * sine,
                                         k1 - (k2 + 1) * cosine + k3, -at.assembly);
  const double coupler = angle_of_tangent(cosine - k1 + k4 * cosine + k5, -2 * sine,
                                          k1 + (k4 - 1) * cosine + k5, -at.assembly);
  if (!std::isfinite(rocker) || !std::isfinite(coupler)) return {};
  return {true, unit(coupler), unit(rocker)};
}

Answer raw_discriminant(const Configuration& at) {
  const double l2 = at.links.coupler, l3 = at.links.rocker;
  const Diagonal d = diagonal(at);
  const double a = (d.square + l2 * l2 - l3 * l3) / 2;
  const double h = at.assembly * std::sqrt(d.square * l2 * l2 - a * a);
  return with_rocker(at, d, (1 / (d.square * l2)) * (Vec2d{a, h} * d.bd));
}

Answer sorted_sides(const Configuration& at) {
  const double l2 = at.links.coupler, l3 = at.links.rocker;
  const Diagonal d = diagonal(at);
  std::array<double, 3> side{l2, l3, std::sqrt(d.square)};
  std::ranges::sort(side, std::greater<>());
  const auto [a, b, c] = side;
  const double h =
      at.assembly * std::sqrt((a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c)));
  const double m = d.square + (l2 - l3) * (l2 + l3);
  return with_rocker(at, d, (0.5 / (d.square * l2)) * (Vec2d{m, h} * d.bd));
}

}  // namespace cognate::stress
