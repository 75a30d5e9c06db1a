#include "analysis/coupler_curve/stationary_curvature.hpp"

#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {
namespace {

constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

}  // namespace

double StationaryCubic::value(const Vec2d& point) const {
  const Vec2d z = conj(axis) * (point - pole);
  return squared_norm(z) * (inverse_m * z.x + inverse_n * z.y) - z.x * z.y;
}

std::optional<Vec2d> StationaryCubic::at(const Vec2d& direction) const {
  const Vec2d ray = conj(axis) * direction;
  const double r = ray.x * ray.y / (inverse_m * ray.x + inverse_n * ray.y);
  const Vec2d point = pole + r * direction;
  if (std::abs(r) <= kRounding * diameter || !is_finite(point)) return std::nullopt;
  return point;
}

std::optional<StationaryCubic> circling_points(const Pole& pole) {
  const double diameter = std::hypot(pole.rate.x, pole.rate.y);
  // The inflection pole lies at −i u, so that u points along −x.
  const Vec2d axis = (-1 / diameter) * pole.rate;
  const Vec2d second = conj(axis) * pole.second;
  const double k = 1 / (3 * diameter);
  const StationaryCubic cubic{pole.at, axis, diameter, k * (2 + second.y / diameter),
                              -k * (second.x / diameter)};
  if (!is_finite(axis) || !std::isfinite(cubic.inverse_m) || !std::isfinite(cubic.inverse_n)) {
    return std::nullopt;
  }
  return cubic;
}

StationaryCubic centre_points(const StationaryCubic& circling) {
  StationaryCubic centres = circling;
  centres.inverse_m -= 1 / circling.diameter;
  return centres;
}

std::vector<Vec2d> sample(const StationaryCubic& cubic, int count, double reach) {
  std::vector<Vec2d> points;
  for (int k = 0; k < count; ++k) {
    const double angle = kPi * k / count;
    const auto point = cubic.at(cubic.axis * unit_vector(angle));
    if (!point) continue;
    const Vec2d z = *point - cubic.pole;
    if (std::hypot(z.x, z.y) <= reach) points.push_back(*point);
  }
  return points;
}

std::optional<Vec2d> ball_point(const StationaryCubic& circling) {
  const double delta = circling.diameter;
  const Vec2d along{delta * circling.inverse_n, 1 - delta * circling.inverse_m};
  if (std::abs(along.y) <= kRounding) return std::nullopt;
  // r = δ sin ψ.
  const Vec2d ray = (1 / std::hypot(along.x, along.y)) * along;
  return circling.pole + (delta * ray.y) * (circling.axis * ray);
}

}  // namespace cognate
