#include "analysis/coupler_curve/contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cognate {
namespace {

constexpr double kContactRounding = 64 * std::numeric_limits<double>::epsilon();

/// Angular velocity and acceleration below this share of the velocity over the size are none.
constexpr double kNoTurn = 1e-13;

/// Loci whose difference is below this share of them are one.
constexpr double kOneLocus = 1e-11;

/// What the point z, counted from B, adds to the k-th coefficient of B: turn·z.
Vec2d turn_of(const ContactSeries& series, int k) {
  return series.direction[static_cast<std::size_t>(k)] * conj(series.direction[0]);
}

Vec2d pin_of(const ContactSeries& series, int k) {
  return series.pin[static_cast<std::size_t>(k)];
}

Vec2d coefficient(const ContactSeries& series, int k, const Vec2d& z) {
  return pin_of(series, k) + turn_of(series, k) * z;
}

}  // namespace

double value(const CircleOrLine& locus, const Vec2d& z) {
  return locus.square * squared_norm(z) + dot(locus.linear, z) + locus.constant;
}

std::optional<Circle> as_circle(const CircleOrLine& locus, double reach) {
  const double half = norm(locus.linear) / 2;
  if (!(half <= reach * std::abs(locus.square)) || locus.square == 0) return std::nullopt;
  const Vec2d centre = (-0.5 / locus.square) * locus.linear;
  const double square = squared_norm(centre) - locus.constant / locus.square;
  return Circle{centre, std::sqrt(std::max(square, 0.0))};
}

std::optional<Line> as_line(const CircleOrLine& locus, double size) {
  const double across = norm(locus.linear);
  if (across == 0 || std::abs(locus.square) * size > kContactRounding * across) return std::nullopt;
  const Vec2d normal = (1 / across) * locus.linear;
  return Line{(-locus.constant / across) * normal, perp(normal)};
}

std::array<std::optional<double>, 2> meet(const CircleOrLine& locus, const Vec2d& from,
                                          const Vec2d& direction) {
  // a t² + 2 b t + c = 0, without cancellation as a falls to zero.
  const double a = locus.square;
  const double b = dot(a * from + 0.5 * locus.linear, direction);
  const double c = value(locus, from);
  double discriminant = b * b - a * c;
  if (std::abs(discriminant) <= kContactRounding * (b * b + std::abs(a * c))) discriminant = 0;
  if (discriminant < 0) return {};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const auto root = [](double above, double below) -> std::optional<double> {
    const double t = above / below;
    return std::isfinite(t) ? std::optional(t) : std::nullopt;
  };
  auto first = root(c, q), second = root(q, a);
  if (!first || first == second) return {second, std::nullopt};
  if (second && *second < *first) std::swap(first, second);
  return {first, second};
}

CircleOrLine contact_locus(const ContactSeries& series, int k) {
  const Vec2d o1 = pin_of(series, 1), ok = pin_of(series, k);
  const Vec2d e1 = turn_of(series, 1), ek = turn_of(series, k);
  // Im((conj(o₁ + e₁z))(oₖ + eₖz)): the linear part is Im(m z).
  const Vec2d m = conj(o1) * ek - conj(ok) * e1;
  return {cross(e1, ek), {m.y, m.x}, cross(o1, ok)};
}

std::array<Vec2d, kContactOrder + 1> path_series(const ContactSeries& series, const Vec2d& z) {
  std::array<Vec2d, kContactOrder + 1> path;
  for (int k = 0; k <= kContactOrder; ++k) {
    path[static_cast<std::size_t>(k)] = coefficient(series, k, z);
  }
  return path;
}

CircleOrLine common_chord(const CircleOrLine& a, const CircleOrLine& b) {
  return {0, b.square * a.linear - a.square * b.linear,
          b.square * a.constant - a.square * b.constant};
}

std::optional<Vec2d> finite(const ProjectivePoint& point, double reach) {
  if (!(norm(point.at) <= reach * std::abs(point.weight)) || point.weight == 0) return std::nullopt;
  return (1 / point.weight) * point.at;
}

ProjectivePoint pole_point(const ContactSeries& series) {
  // o₁ + i w z = 0.
  return {perp(pin_of(series, 1)), turn_of(series, 1).y};
}

FourPointContact four_point_contact(const ContactSeries& series, double size) {
  const double w1 = turn_of(series, 1).y, w2 = turn_of(series, 2).y;
  if (std::max(std::abs(w1), std::abs(w2)) * size <= kNoTurn * norm(pin_of(series, 1))) return {};
  const CircleOrLine second = contact_locus(series, 2), third = contact_locus(series, 3);
  // The common chord: the squares are w₁³ and w₁² 2 w₂ but for one factor.
  const Vec2d across = w1 * third.linear - (2 * w2) * second.linear;
  const double constant = w1 * third.constant - 2 * w2 * second.constant;
  const double length = norm(across);
  // The size of third coefficients where they do not vanish, as all do in a limit position.
  double third_terms = 0;
  for (int k = 1; k <= 3; ++k) {
    third_terms = std::max(third_terms, norm(pin_of(series, k)) + norm(turn_of(series, k)) * size);
  }
  const double turning = std::abs(w1) + std::abs(2 * w2);
  const double first_terms = norm(pin_of(series, 1)) + std::abs(w1) * size;
  const double terms = turning * first_terms * third_terms / size;
  if (length <= kOneLocus * terms) return {FourPointContact::Kind::locus, {}};
  const Vec2d normal = (1 / length) * across, along = perp(normal);
  // A point of the chord to count from, not nearer to the pole than `size`.
  const double to_pole = dot(perp(pin_of(series, 1)), along);
  const double side = -std::copysign(size, to_pole * w1);
  const Vec2d from = (-constant / length) * normal + side * along;
  const double pole = to_pole - side * w1;  // w₁ times the pole's distance from there
  const Vec2d o1 = coefficient(series, 1, from), o2 = coefficient(series, 2, from);
  const Vec2d o3 = coefficient(series, 3, from);
  // The product of the distances, as the second circle has it (times w₁) and the third (times w₂).
  const double weight = w1 * (w2 * w2 + w1 * w1) * pole;
  const double reach = w2 * cross(o1, o3) + 2 * w1 * cross(o1, o2);
  const double reach_terms = norm(o1) * turning * std::max(third_terms, norm(o3));
  if (std::abs(reach) + std::abs(weight) * size <= kOneLocus * reach_terms) {
    return {FourPointContact::Kind::locus, {}};
  }
  const Vec2d at = weight * from + reach * along;
  const double scale = 1 / std::max(norm(at) / size, std::abs(weight));
  return {FourPointContact::Kind::point, {scale * at, scale * weight}};
}

double contact_value(const ContactSeries& series, int k, const ProjectivePoint& point) {
  const CircleOrLine locus = contact_locus(series, k);
  return locus.square * squared_norm(point.at) +
         point.weight * (dot(locus.linear, point.at) + point.weight * locus.constant);
}

Contact contact(const ContactSeries& series, const Vec2d& z, double size, double tolerance) {
  const auto path = path_series(series, z);
  const double speed = norm(path[1]);
  Contact result;
  if (speed <= tolerance * (norm(series.pin[1]) + norm(series.direction[1]) * norm(z)) ||
      speed == 0) {
    return result;
  }
  result.tangent = (1 / speed) * path[1];
  double scale = 1 / size;  // (size/speed)ᵏ/size
  for (int k = 2; k <= kContactOrder; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const double deviation = cross(result.tangent, path[index]);
    const double terms = norm(series.pin[index]) + norm(series.direction[index]) * norm(z);
    result.points = k;
    result.coefficient = scale * std::pow(size / speed, k) * deviation;
    if (std::abs(deviation) > tolerance * terms) return result;
    if (terms > 0) result.residual = std::max(result.residual, std::abs(deviation) / terms);
  }
  result.points = kContactOrder + 1;
  result.coefficient = 0;
  return result;
}

}  // namespace cognate
