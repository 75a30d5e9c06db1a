#include "analysis/coupler_curve/pole.hpp"

#include <cmath>
#include <limits>

#include "analysis/numbers/vec2.hpp"

namespace cognate {
namespace {

constexpr double kPoleRounding = 16 * std::numeric_limits<double>::epsilon();

Centrode centrode(const Vec2d& at, const Vec2d& rate, const Vec2d& second) {
  const double speed = norm(rate);
  const Vec2d tangent = (1 / speed) * rate;
  const double curvature = cross(tangent, second) / speed / speed;
  if (!is_finite(tangent) || !std::isfinite(curvature)) return {at, {}, {}};
  return {at, tangent, curvature};
}

}  // namespace

InstantMotion instant_motion(const BodyMotion<double, 3>& body, double h) {
  if (std::abs(body.turn[0]) * h > kPoleRounding) return InstantMotion::rotation;
  const bool stands = norm(body.origin[1]) <= kPoleRounding * h * norm(body.origin[2]);
  return stands ? InstantMotion::rest : InstantMotion::translation;
}

std::optional<Pole> pole(const BodyMotion<double, 3>& body, double h) {
  if (instant_motion(body, h) != InstantMotion::rotation) return std::nullopt;
  const auto [first, second, third] = body.turn;
  const double k = 1 / first;
  const double spin = k * k * second;
  // The derivatives of the origin by φ.
  const Vec2d o1 = k * body.origin[1];
  const Vec2d o2 = k * k * body.origin[2] - spin * o1;
  const Vec2d o3 = k * k * k * body.origin[3] - (3 * spin) * o2 - (k * k * k * third) * o1;
  const Pole result{body.origin[0] + perp(o1), o1 + perp(o2), o2 + perp(o3), first, spin};
  if (!is_finite(result.at) || !is_finite(result.rate) || !is_finite(result.second)) return {};
  return result;
}

Vec2d pole_velocity(const Pole& pole) {
  return pole.turn * pole.rate;
}

Centrode fixed_centrode(const Pole& pole) {
  return centrode(pole.at, pole.rate, pole.second);
}

Centrode moving_centrode(const BodyMotion<double, 3>& body, const Pole& pole) {
  const Vec2d to_body = conj(body.direction);
  return centrode(to_body * (pole.at - body.origin[0]), to_body * pole.rate,
                  to_body * (pole.second - perp(pole.rate)));
}

}  // namespace cognate
