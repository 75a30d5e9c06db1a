#include "synthesis/exact/binary_form.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// A discriminant below this share of its terms is zero: a few dozen roundings.
constexpr double kDiscriminantNoise = 64 * kEpsilon;

Vec2d unit(double alpha, double beta) {
  const double size = std::hypot(alpha, beta);
  return {alpha / size, beta / size};
}

/// a·b − c·d, rounded about once (Kahan).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

template <std::size_t N>
bool normalise(std::array<double, N>& c) {
  double largest = 0;
  for (const double value : c) largest = std::max(largest, std::abs(value));
  if (!(largest > 0) || !std::isfinite(largest)) return false;
  const int exponent = std::ilogb(largest);  // by a power of two, so that nothing is rounded
  for (double& value : c) value = std::scalbn(value, -exponent);
  return true;
}

double value(const std::array<double, 4>& c, double alpha, double beta) {
  return ((c[0] * alpha + c[1] * beta) * alpha + c[2] * beta * beta) * alpha +
         c[3] * beta * beta * beta;
}

/// The coefficients in axes turned so that the first is (x, y).
std::array<double, 4> turned(const std::array<double, 4>& c, double x, double y) {
  // α = x·a − y·b, β = y·a + x·b.
  return {value(c, x, y),
          -3 * c[0] * x * x * y + c[1] * (x * x * x - 2 * x * y * y) +
              c[2] * (2 * x * x * y - y * y * y) + 3 * c[3] * x * y * y,
          3 * c[0] * x * y * y + c[1] * (y * y * y - 2 * x * x * y) +
              c[2] * (x * x * x - 2 * x * y * y) + 3 * c[3] * x * x * y,
          value(c, -y, x)};
}

/// A step or two of Newton's on x³ + bx² + cx + d, taken only where it lessens the value.
double refined(double x, double b, double c, double d) {
  const auto at = [&](double t) { return std::fma(std::fma(t + b, t, c), t, d); };
  double here = at(x);
  for (int i = 0; i < 3 && here != 0; ++i) {
    const double slope = (3 * x + 2 * b) * x + c;
    const double next = x - here / slope;
    const double there = at(next);
    if (!(std::abs(there) < std::abs(here))) break;
    x = next;
    here = there;
  }
  return x;
}

/// The real roots of x³ + bx² + cx + d (Viète's form where there are three).
InPlaceVector<double, 3> monic_roots(double b, double c, double d) {
  const double p = b * b / 9 - c / 3;  // t³ = 3pt + 2q with x = t − b/3
  const double q = (b * c / 3 - d - 2 * b * b * b / 27) / 2;
  const double cube = p * p * p, square = q * q;
  const double noise = kDiscriminantNoise * (std::abs(cube) + square +
                                             std::abs(q) * (std::abs(b * b * b) + std::abs(d)));
  InPlaceVector<double, 3> roots;
  if (square - cube <= noise && p > 0) {
    const double size = std::sqrt(p);
    const double angle = std::acos(std::clamp(q / (p * size), -1.0, 1.0)) / 3;
    for (int k = 0; k < 3; ++k) {
      roots.push_back(2 * size * std::cos(angle - kTurn * k / 3) - b / 3);
    }
  } else {
    const double root = std::cbrt(std::abs(q) + std::sqrt(std::max(0.0, square - cube)));
    const double t = root == 0 ? 0 : root + p / root;
    roots.push_back(std::copysign(t, q) - b / 3);
  }
  for (double& x : roots) x = refined(x, b, c, d);
  return roots;
}

}  // namespace

InPlaceVector<Vec2d, 2> real_roots(const std::array<double, 3>& coefficients) {
  InPlaceVector<Vec2d, 2> roots;
  std::array<double, 3> c = coefficients;
  if (!normalise(c)) return roots;
  const double half = 0.5 * c[1];
  const double discriminant = difference_of_products(half, half, c[0], c[2]);
  if (discriminant < -kDiscriminantNoise * (half * half + std::abs(c[0] * c[2]))) return roots;
  // The sum without cancellation gives one root, the product of both the other.
  const double sum = -(half + std::copysign(std::sqrt(std::max(0.0, discriminant)), half));
  if (sum == 0) {  // c₁ = 0 and c₀ or c₂ too
    const Vec2d root = c[0] == 0 ? Vec2d{1, 0} : Vec2d{0, 1};
    roots.push_back(root);
    roots.push_back(root);
    return roots;
  }
  roots.push_back(unit(sum, c[0]));
  roots.push_back(unit(c[2], sum));
  return roots;
}

InPlaceVector<Vec2d, 3> real_roots(const std::array<double, 4>& coefficients) {
  InPlaceVector<Vec2d, 3> roots;
  std::array<double, 4> c = coefficients;
  if (!normalise(c)) return roots;
  // Of four directions at most three can be near a root: in axes with the one where the form is
  // greatest, every root is finite and of moderate size.
  constexpr double kHalf = std::numbers::sqrt2 / 2;
  constexpr std::array<Vec2d, 4> kDirections{Vec2d{1, 0}, Vec2d{kHalf, kHalf}, Vec2d{0, 1},
                                             Vec2d{-kHalf, kHalf}};
  Vec2d axis = kDirections[0];
  for (const Vec2d& next : kDirections) {
    if (std::abs(value(c, next.x, next.y)) > std::abs(value(c, axis.x, axis.y))) axis = next;
  }
  const auto own = turned(c, axis.x, axis.y);
  for (const double x : monic_roots(own[1] / own[0], own[2] / own[0], own[3] / own[0])) {
    roots.push_back(unit(axis.x * x - axis.y, axis.y * x + axis.x));
  }
  return roots;
}

}  // namespace cognate::synthesis
