#include "tests/stress/exact_closure.hpp"

#include <algorithm>

namespace cognate::stress {
namespace {

Vec2<Exact> exact(const Vec2d& v) {
  return {Exact(v.x), Exact(v.y)};
}

/// e^{iθ} of the half angle vector, which need not be of length one.
Vec2<Exact> full_angle(const Vec2d& half_crank) {
  const Vec2<Exact> half = exact(half_crank);
  return (1 / squared_norm(half)) * (half * half);
}

/// Σ|x·∂θ/∂x| over both components of the half angle vector.
Exact angle_sensitivity(const Vec2d& half_crank) {
  const Vec2<Exact> half = exact(half_crank);
  return 4 * abs(half.x * half.y) / squared_norm(half);
}

/// Of the side x against the other two: |g|/Σ|x·∂g/∂x| for g = d² − (l₂ ∓ l₃)².
Exact relative_gap(const Lengths<Exact>& l, const Exact& rocker, const Exact& d2,
                   const Exact& diagonal_sensitivity) {
  const Exact side = l.coupler + rocker;
  const Exact sensitivity = diagonal_sensitivity + 2 * abs(side) * (l.coupler + abs(rocker));
  return abs(d2 - side * side) / sensitivity;
}

/// Σ|x·∂P/∂x| of P = l₁e₁ + e₂·(u, v); `phi` is the gradient of the angle of e₂.
Exact point_sensitivity(const Configuration& at, const Lengths<Exact>& l, const Vec2<Exact>& e1,
                        const Vec2<Exact>& e2, const AngleGradient<Exact>& phi) {
  const auto norm = [](const Vec2<Exact>& v) { return Exact(sqrt(squared_norm(v))); };
  const Vec2<Exact> uv = exact(at.coupler_point);
  const Vec2<Exact> by_phi = perp(e2 * uv);
  const Exact by_crank = norm(e1 + phi.crank * by_phi);
  const Exact by_crank_angle = norm(l.crank * perp(e1) + phi.crank_angle * by_phi);
  const Exact turning =
      l.coupler * abs(phi.coupler) + l.rocker * abs(phi.rocker) + l.frame * abs(phi.frame);
  return l.crank * by_crank + angle_sensitivity(at.half_crank) * by_crank_angle +
         turning * norm(uv) + abs(uv.x) + abs(uv.y);
}

Exact sensitivity(const AngleGradient<Exact>& g, const Lengths<Exact>& l, const Exact& of_angle) {
  return abs(l.crank * g.crank) + abs(l.coupler * g.coupler) + abs(l.rocker * g.rocker) +
         abs(l.frame * g.frame) + of_angle * abs(g.crank_angle);
}

}  // namespace

ExactClosure exact_closure(const Configuration& at) {
  const Lengths<Exact> l{at.links.crank, at.links.coupler, at.links.rocker, at.links.frame};
  const Vec2<Exact> e1 = full_angle(at.half_crank);
  const Vec2<Exact> bd = Vec2<Exact>{l.frame, 0} - l.crank * e1;
  const Exact d2 = squared_norm(bd);
  const Exact m = d2 + l.coupler * l.coupler - l.rocker * l.rocker;
  const Exact h2 = 4 * d2 * l.coupler * l.coupler - m * m;

  ExactClosure result;
  result.closes = h2 >= 0 && d2 > 0;
  const Exact of_angle = angle_sensitivity(at.half_crank);
  const Exact cosine_part = 2 * l.crank * l.frame * e1.x;
  const Exact of_diagonal = abs(2 * l.crank * l.crank - cosine_part) +
                            abs(2 * l.frame * l.frame - cosine_part) +
                            of_angle * abs(2 * l.crank * l.frame * e1.y);
  result.boundary_distance = double(std::min(relative_gap(l, l.rocker, d2, of_diagonal),
                                             relative_gap(l, -l.rocker, d2, of_diagonal))) /
                             kUnit;
  if (!result.closes) return result;

  const Exact h = Exact(at.assembly) * sqrt(h2);
  result.coupler = (1 / (2 * d2 * l.coupler)) * (Vec2<Exact>{m, h} * bd);
  const Vec2<Exact> joint = l.crank * e1 + l.coupler * result.coupler;
  result.rocker = (1 / l.rocker) * (joint - Vec2<Exact>{l.frame, 0});
  result.point = l.crank * e1 + result.coupler * exact(at.coupler_point);

  const auto gradient =
      closure_gradient(l, e1, LinkDirections<Exact>{result.coupler, result.rocker, h2});
  result.coupler_condition = double(sensitivity(gradient.coupler, l, of_angle));
  result.rocker_condition = double(sensitivity(gradient.rocker, l, of_angle));
  result.size = at.links.crank + double(sqrt(squared_norm(exact(at.coupler_point))));
  result.point_condition =
      double(point_sensitivity(at, l, e1, result.coupler, gradient.coupler)) / result.size;
  return result;
}

Vec2d rounded_crank(const Vec2d& half_crank) {
  const Vec2<Exact> e1 = full_angle(half_crank);
  return {double(e1.x), double(e1.y)};
}

Vec2d half_crank_for(const Lengths<double>& links, const Exact& diagonal) {
  const Exact l1 = links.crank, l4 = links.frame;
  const Exact square = 4 * l1 * l4;
  const Exact opposite = (diagonal - (l4 - l1)) * (diagonal + (l4 - l1));
  const Exact adjacent = ((l4 + l1) - diagonal) * ((l4 + l1) + diagonal);
  const auto root = [&](const Exact& part) {
    return part > 0 ? double(sqrt(Exact(part / square))) : 0.0;
  };
  return {root(adjacent), root(opposite)};
}

double distance(const Vec2d& a, const Vec2<Exact>& b) {
  const Vec2<Exact> error{a.x - b.x, a.y - b.y};
  return double(sqrt(squared_norm(error))) / kUnit;
}

}  // namespace cognate::stress
