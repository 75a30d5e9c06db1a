#include "synthesis/exact/motion/null_space_pivots.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/vec2.hpp"
#include "synthesis/exact/binary_form.hpp"

namespace cognate::synthesis {
namespace {

/// The real common points of two conics, homogeneous unit vectors. Two points that nearly fall
/// together, real or not, are both given, at the accuracy of the square root of rounding: refine
/// and compare.
struct ConicIntersection {
  std::array<Eigen::Vector3d, 4> points;
  int count = 0;
  /// The conics share a line (all its points are common) or are one; `points` are examples of it.
  bool common_curve = false;
};

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

/// The points of xᵀ a x = xᵀ b x = 0, a and b symmetric: a degenerate conic of their pencil that
/// splits into real lines is met by another conic.
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

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The quadratic form x_i x_j in the coordinates of the null space.
Matrix3d square_form(const PivotNullSpace& basis, int i, int j) {
  const Matrix3d product = basis.row(i).transpose() * basis.row(j);
  return 0.5 * (product + product.transpose());
}

/// The pivots of x = (h, w, g, q), by the larger of w and g. Both vectors vanish where w and g do.
PivotPair pivots_of(const PivotUnknowns& x) {
  const Vec2d w{x[1], x[2]}, g{x[3], x[4]}, q{x[5], x[6]};
  const double ww = squared_norm(w), gg = squared_norm(g);
  if (gg >= ww) {
    const Vec2d u = q * g;
    return {Vector3d(u.x, u.y, gg), Vector3d(g.x, g.y, x[0])};
  }
  const Vec2d v = conj(q) * w;
  return {Vector3d(w.x, w.y, x[0]), Vector3d(v.x, v.y, ww)};
}

}  // namespace

NullSpacePivots pivots_of_null_space(const PivotNullSpace& basis) {
  const auto form = [&](int i, int j) { return square_form(basis, i, j); };
  // q h = w ḡ: its real and its imaginary part.
  const Matrix3d real = form(0, 5) - form(1, 3) - form(2, 4);
  const Matrix3d imaginary = form(0, 6) - form(2, 3) + form(1, 4);
  const ConicIntersection common = intersect(real, imaginary);
  NullSpacePivots found;
  found.common_curve = common.common_curve;
  for (int k = 0; k < common.count; ++k) {
    PivotPair pair = pivots_of(basis * common.points[static_cast<std::size_t>(k)]);
    if (!(pair.moving.norm() > 0) || !(pair.fixed.norm() > 0)) continue;
    pair.moving.normalize();
    pair.fixed.normalize();
    found.pairs[static_cast<std::size_t>(found.count++)] = pair;
  }
  return found;
}

}  // namespace cognate::synthesis
