#include "analysis/coupler_curve/path_curvature.hpp"

#include <cmath>
#include <limits>

namespace cognate {
namespace {

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<Vec2d> if_finite(const Vec2d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) ? std::optional(v) : std::nullopt;
}

}  // namespace

std::optional<double> curvature(std::span<const Vec2d> motion) {
  const double speed = norm(motion[1]);
  return if_finite(cross((1 / speed) * motion[1], motion[2]) / speed / speed);
}

std::optional<double> curvature_rate(const std::array<Vec2d, 4>& motion) {
  const double speed = norm(motion[1]);
  const double k = 1 / speed;
  const Vec2d tangent = k * motion[1];
  const Vec2d second = (k * k) * motion[2], third = (k * k * k) * motion[3];
  return if_finite(cross(tangent, third) - 3 * cross(tangent, second) * dot(tangent, second));
}

std::optional<Vec2d> centre_of_curvature(const std::array<Vec2d, 4>& motion) {
  const double bend = cross(motion[1], motion[2]);
  if (bend == 0) return std::nullopt;
  return if_finite(motion[0] + (squared_norm(motion[1]) / bend) * perp(motion[1]));
}

Circle inflection_circle(const Pole& pole) {
  return {pole.at - 0.5 * perp(pole.rate), 0.5 * norm(pole.rate)};
}

Vec2d inflection_pole(const Pole& pole) {
  return pole.at - perp(pole.rate);
}

Circle return_circle(const Pole& pole) {
  return {pole.at + 0.5 * perp(pole.rate), 0.5 * norm(pole.rate)};
}

std::optional<Circle> tangential_circle(const Pole& pole, double spin) {
  // P″ · P′ = 0 for P″ = (i·spin − 1) z − i u and P′ = i z: spin |z|² = z · u.
  const auto to_centre = if_finite((0.5 / spin) * pole.rate);
  if (!to_centre) return std::nullopt;
  return Circle{pole.at + *to_centre, norm(*to_centre)};
}

Vec2d acceleration_pole(const Pole& pole, double spin) {
  // (i·spin − 1) z = i u.
  return pole.at + (1 / (1 + spin * spin)) * (Vec2d{spin, -1} * pole.rate);
}

std::optional<Vec2d> conjugate_centre(const Pole& pole, const Vec2d& point) {
  const Vec2d z = point - pole.at;
  const double along = cross(z, pole.rate);
  return if_finite(pole.at + (along / (along - squared_norm(z))) * z);
}

std::optional<Vec2d> conjugate_point(const Pole& pole, const Vec2d& centre) {
  const Vec2d c = centre - pole.at;
  const double along = cross(c, pole.rate);
  return if_finite(pole.at + (along / (along + squared_norm(c))) * c);
}

std::optional<Line> inflection_line(const BodyMotion<double, 3>& body, double h) {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  if (instant_motion(body, h) != InstantMotion::translation) return std::nullopt;
  if (std::abs(body.turn[1]) * h * h <= kRounding) return std::nullopt;
  // v × (O″ + φ″ i p) = 0 for p = P − O: v · p = −(v × O″)/φ″.
  const Vec2d& v = body.origin[1];
  const double speed = norm(v);
  const auto foot =
      if_finite((-cross(v, body.origin[2]) / body.turn[1] / speed / speed) * v + body.origin[0]);
  if (!foot) return std::nullopt;
  return Line{*foot, (1 / speed) * perp(v)};
}

}  // namespace cognate
