#include "synthesis/exact/motion/quartic_signs.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Vector2d;
using Quartic = std::array<double, 5>;

/// Values below this share of the sum of their terms are zero: the coefficients are products of six
/// rounded numbers.
constexpr double kNoise = 256 * std::numeric_limits<double>::epsilon();
/// Roots nearer than this may be one: the square root of the noise, with a margin.
constexpr double kDouble = 1e-5;

/// The form over axes turned so that its value on the first axis is the greatest of eight: in z =
/// X/Y its polynomial then has all roots of moderate size.
struct Turned {
  Quartic c{};
  Vector2d axis{1, 0};

  double angle(double z) const {
    const Vector2d at = z * axis + Vector2d(-axis.y(), axis.x());
    const double angle = std::atan2(at.y(), at.x());
    return angle < 0 ? angle + kPi : angle;
  }
};

/// Σ cₖ L₁^{n−k} L₂^k with the linear forms L₁, L₂ given by their coefficients, by Horner's rule.
Quartic substituted(const Quartic& c, const Vector2d& l1, const Vector2d& l2) {
  Quartic sum{}, power{};
  sum[0] = c[0];
  power[0] = 1;
  const auto multiply = [](Quartic& form, std::size_t degree, const Vector2d& l) {
    for (std::size_t k = degree + 1; k > 0; --k) form[k] = l.x() * form[k] + l.y() * form[k - 1];
    form[0] *= l.x();
  };
  for (std::size_t degree = 1; degree < 5; ++degree) {
    multiply(sum, degree - 1, l1);
    multiply(power, degree - 1, l2);
    for (std::size_t k = 0; k <= degree; ++k) sum[k] += c[degree] * power[k];
  }
  return sum;
}

Turned turned(const Quartic& c) {
  Turned result;
  double greatest = -1;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * kPi / 8;
    const Vector2d axis(std::cos(angle), std::sin(angle));
    const double value = std::abs(binary_form(c, axis));
    if (value > greatest) {
      greatest = value;
      result.axis = axis;
    }
  }
  const Vector2d& a = result.axis;
  result.c = substituted(c, {a.x(), -a.y()}, {a.y(), a.x()});
  return result;
}

struct Value {
  double value = 0;
  double noise = 0;
};

Value evaluate(const Quartic& c, double z) {
  Value at{c[0], std::abs(c[0])};
  for (std::size_t k = 1; k < 5; ++k) {
    at.value = at.value * z + c[k];
    at.noise = at.noise * std::abs(z) + std::abs(c[k]);
  }
  at.noise *= kNoise;
  return at;
}

/// Real parts of the roots, in ascending order.
std::array<double, 4> real_parts(const Quartic& c) {
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.diagonal(-1).setOnes();
  for (int k = 0; k < 4; ++k) companion(k, 3) = -c[static_cast<std::size_t>(4 - k)] / c[0];
  const Eigen::EigenSolver<Eigen::Matrix4d> solver(companion, false);
  std::array<double, 4> parts{};
  for (int k = 0; k < 4; ++k) parts[static_cast<std::size_t>(k)] = solver.eigenvalues()[k].real();
  std::ranges::sort(parts);
  return parts;
}

double bisected(const Quartic& c, double low, double high) {
  const bool rising = evaluate(c, high).value > 0;
  for (int i = 0; i < 120; ++i) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) break;
    ((evaluate(c, middle).value > 0) == rising ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Adds `angle` in ascending order.
template <std::size_t Most>
void insert(InPlaceVector<double, Most>& angles, double angle) {
  angles.push_back(angle);
  for (std::size_t k = angles.size() - 1; k > 0 && angles[k] < angles[k - 1]; --k) {
    std::swap(angles[k], angles[k - 1]);
  }
}

bool is_double(const Quartic& c, double first, double second) {
  const Value at = evaluate(c, 0.5 * (first + second));
  return std::abs(at.value) <= at.noise && second - first <= kDouble * (1 + std::abs(first));
}

}  // namespace

double binary_form(std::span<const double> c, const Vector2d& at) {
  double sum = 0, power = 1;
  for (const double coefficient : c) {
    sum = sum * at.x() + coefficient * power;
    power *= at.y();
  }
  return sum;
}

SignsOfQuartic signs_of(const std::array<double, 5>& c) {
  SignsOfQuartic roots;
  const Turned form = turned(c);
  if (!(std::abs(form.c[0]) > 0)) return roots;
  const std::array<double, 4> parts = real_parts(form.c);
  std::array<double, 9> nodes{};
  nodes[0] = parts[0] - 0.1 * (1 + std::abs(parts[0]));
  nodes[8] = parts[3] + 0.1 * (1 + std::abs(parts[3]));
  for (std::size_t k = 0; k < 4; ++k) {
    nodes[2 * k + 1] = parts[k];
    if (k > 0) nodes[2 * k] = 0.5 * (parts[k - 1] + parts[k]);
  }
  double before = nodes[0];
  bool positive = evaluate(form.c, before).value > 0;
  for (const double node : nodes) {
    const Value at = evaluate(form.c, node);
    if (std::abs(at.value) <= at.noise) continue;
    if ((at.value > 0) != positive && roots.changes.size() < 4) {
      insert(roots.changes, form.angle(bisected(form.c, before, node)));
      positive = !positive;
    }
    before = node;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (!is_double(form.c, parts[k], parts[k + 1])) continue;
    insert(roots.touches, form.angle(0.5 * (parts[k] + parts[k + 1])));
    ++k;
  }
  return roots;
}

}  // namespace cognate::synthesis
