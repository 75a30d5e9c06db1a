#include "analysis/coupler_curve/parallel_cranks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cognate {
namespace {

Vec2d coupler_vector(const ParallelCranks& cranks) {
  return {cranks.coupler * std::cos(cranks.coupler_angle),
          cranks.coupler * std::sin(cranks.coupler_angle)};
}

double side(const ParallelCranks& cranks) {
  return cranks.sides == CrankSides::same ? 1 : -1;
}

/// c ∓ a, or empty where rounding explains it.
std::optional<double> difference(const ParallelCranks& cranks) {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  const double value = cranks.rocker - side(cranks) * cranks.crank;
  if (std::abs(value) <= kRounding * std::max(cranks.crank, cranks.rocker)) return std::nullopt;
  return value;
}

/// Where the line through p along u meets the line through q along v.
std::optional<Vec2d> intersection(const Vec2d& p, const Vec2d& u, const Vec2d& q, const Vec2d& v) {
  const double t = cross(q - p, v) / cross(u, v);
  if (!std::isfinite(t)) return std::nullopt;
  return p + t * u;
}

}  // namespace

ParallelPose pose(const ParallelCranks& cranks) {
  const Vec2d b{0, cranks.crank};
  const Vec2d c = b + coupler_vector(cranks);
  return {b, c, c - Vec2d{0, side(cranks) * cranks.rocker}};
}

std::optional<FourBar> four_bar(const ParallelCranks& cranks) {
  constexpr double kInLine = 1e-9;
  if (std::abs(std::cos(cranks.coupler_angle)) < kInLine) return std::nullopt;
  const auto [b, c, d] = pose(cranks);
  FourBar linkage{{}, d, cranks.crank, cranks.coupler, cranks.rocker};
  // (D − B) × (C − B) = (D − C) × (C − B).
  const bool open = side(cranks) * (c - b).x > 0;
  linkage.assembly = open ? Assembly::open : Assembly::crossed;
  return linkage;
}

double path_curvature(const ParallelCranks& cranks, double x) {
  const double at_b = -1 / cranks.crank, at_c = -side(cranks) / cranks.rocker;
  return at_b + (at_c - at_b) * (x / coupler_vector(cranks).x);
}

std::optional<double> inflection_line_x(const ParallelCranks& cranks) {
  const auto below = difference(cranks);
  if (!below) return std::nullopt;
  return coupler_vector(cranks).x * (cranks.rocker / *below);
}

std::optional<Vec2d> coupler_line_point(const ParallelCranks& cranks) {
  const auto below = difference(cranks);
  if (!below) return std::nullopt;
  return (cranks.rocker / *below) * coupler_vector(cranks);
}

std::optional<Vec2d> constructed_point(const ParallelCranks& cranks) {
  if (!difference(cranks)) return std::nullopt;
  const auto [b, c, d] = pose(cranks);
  const Vec2d crank{0, 1}, coupler = c - b;
  const auto through_a = intersection({}, coupler, d, crank);
  const auto through_d = intersection(d, coupler, {}, crank);
  if (!through_a || !through_d) return std::nullopt;
  const auto point = intersection(b, coupler, *through_d, *through_a - *through_d);
  if (!point) return std::nullopt;
  return *point - b;
}

std::optional<Vec2d> five_point_contact(const ParallelCranks& cranks) {
  constexpr double kAcross = 1e-12;
  const auto below = difference(cranks);
  if (!below || std::abs(std::sin(cranks.coupler_angle)) > kAcross) return std::nullopt;
  const Vec2d coupler = coupler_vector(cranks);
  const double ratio = coupler.x / *below;
  const double rise = side(cranks) * cranks.rocker + cranks.crank;
  return Vec2d{ratio * cranks.rocker, rise * ratio * ratio};
}

double curvature_rate(const ParallelCranks& cranks) {
  return side(cranks) * 3 * std::tan(cranks.coupler_angle) / (cranks.crank * cranks.rocker);
}

}  // namespace cognate
