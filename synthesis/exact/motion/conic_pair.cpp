#include "synthesis/exact/motion/conic_pair.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "synthesis/exact/binary_form.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Below this a conic of norm 1 is degenerate, or vanishes on a line.
constexpr double kZero = 1e-12;
/// Points nearer than the root of this (in the parameter of a line) may be real or not.
constexpr double kNearlyDouble = 1e-12;

Matrix3d adjugate(const Matrix3d& m) {
  Matrix3d result;
  for (int i = 0; i < 3; ++i) {
    result.row(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3)).transpose();
  }
  return result;
}

struct LinePair {
  Vector3d first, second;
  double realness = 0;  ///< positive for distinct real lines, negative for conjugate ones
};

/// A degenerate conic as two lines: C + [p]ₓ has rank one, p their common point, adj C = −p pᵀ
/// (Richter-Gebert, Perspectives on Projective Geometry, 2011, section 11.1).
LinePair lines_of(const Matrix3d& conic) {
  const Matrix3d adjoint = adjugate(conic);
  Eigen::Index i = 0, j = 0;
  const double diagonal = adjoint.diagonal().cwiseAbs().maxCoeff(&i);
  const double sign = adjoint(i, i) < 0 ? 1 : -1;
  Vector3d p = Vector3d::Zero();
  if (diagonal > 0 && sign > 0) p = adjoint.col(i) / std::sqrt(diagonal);
  Matrix3d product = conic;
  product(0, 1) -= p.z();
  product(1, 0) += p.z();
  product(0, 2) += p.y();
  product(2, 0) -= p.y();
  product(1, 2) -= p.x();
  product(2, 1) += p.x();
  product.cwiseAbs().maxCoeff(&i, &j);
  return {product.row(i).transpose().normalized(), product.col(j).normalized(), sign * diagonal};
}

/// det(x a + y b) as a form in (x, y).
std::array<double, 4> pencil_determinant(const Matrix3d& a, const Matrix3d& b) {
  return {a.determinant(), (adjugate(a) * b).trace(), (a * adjugate(b)).trace(), b.determinant()};
}

struct PointsOfLine {
  std::array<Vector3d, 2> points;
  int count = 0;
  bool all = false;
};

PointsOfLine meet(const Vector3d& line, const Matrix3d& conic) {
  const Vector3d s = line.unitOrthogonal(), t = line.cross(s);
  const double a = s.dot(conic * s), b = s.dot(conic * t), c = t.dot(conic * t);
  PointsOfLine result;
  const double size = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (size <= kZero) {
    result.all = true;
    result.points = {s, t};
    result.count = 2;
    return result;
  }
  const double discriminant = b * b - a * c;
  if (discriminant < -kNearlyDouble * size * size) return result;
  const double root = std::sqrt(std::abs(discriminant));
  const double q = -(b + std::copysign(root, b));
  const Vector2d first(q, a), second(c, q);
  for (const Vector2d& at : {first, second}) {
    if (at.norm() > 0) {
      result.points[static_cast<std::size_t>(result.count++)] =
          (at.x() * s + at.y() * t).normalized();
    }
  }
  return result;
}

void add(ConicIntersection& to, const Vector3d& point) {
  if (to.count < 4) to.points[static_cast<std::size_t>(to.count++)] = point;
}

/// The best conditioned pair of real lines in the pencil, and another conic of it.
struct Split {
  LinePair lines;
  Matrix3d other;
};

Split best_split(const Matrix3d& a, const Matrix3d& b, const InPlaceVector<Vec2d, 3>& degenerate) {
  Split best;
  bool first = true;
  for (const Vec2d& at : degenerate) {
    const LinePair lines = lines_of(at.x * a + at.y * b);
    if (first || lines.realness > best.lines.realness) {
      best = {lines, at.x * b - at.y * a};
    }
    first = false;
  }
  return best;
}

}  // namespace

ConicIntersection intersect(const Matrix3d& first, const Matrix3d& second) {
  ConicIntersection result;
  const Matrix3d a = first / first.norm();
  Matrix3d b = second / second.norm();
  b -= a.cwiseProduct(b).sum() * a;
  if (!(b.norm() > kZero)) {
    result.common_curve = true;
    return result;
  }
  b /= b.norm();
  const std::array<double, 4> determinant = pencil_determinant(a, b);
  InPlaceVector<Vec2d, 3> degenerate = real_roots(determinant);
  const bool all_degenerate =
      std::ranges::all_of(determinant, [](double c) { return std::abs(c) <= kZero; });
  if (all_degenerate) {
    degenerate = {};
    degenerate.push_back({1, 0});
    degenerate.push_back({0, 1});
  }
  const Split split = best_split(a, b, degenerate);
  if (split.lines.realness < -kZero) return result;
  for (const Vector3d& line : {split.lines.first, split.lines.second}) {
    const PointsOfLine points = meet(line, split.other);
    result.common_curve = result.common_curve || points.all;
    for (int k = 0; k < points.count; ++k) add(result, points.points[static_cast<std::size_t>(k)]);
  }
  return result;
}

}  // namespace cognate::synthesis
