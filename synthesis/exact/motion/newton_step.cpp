#include "synthesis/exact/motion/newton_step.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "synthesis/exact/motion/guidance_forms.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Tangents = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2>;
/// One row for each form, one column for each tangent of u and v.
using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;

constexpr int kMostSteps = 8;
constexpr double kWorstCondition = 1e300;

/// Orthonormal tangents of the unit sphere at `x`; of its equator where `x` is to stay on it.
Tangents tangents(const Vector3d& x, bool at_infinity) {
  if (at_infinity) return Tangents(Vector3d(-x.y(), x.x(), 0));
  Tangents result(3, 2);
  result.col(0) = x.unitOrthogonal();
  result.col(1) = x.cross(result.col(0));
  return result;
}

struct Linearised {
  Tangents along_u, along_v;
  Jacobian jacobian;
};

Linearised linearised(std::span<const Matrix3d> forms, const PivotPair& pair, Pinned pinned) {
  Linearised at{tangents(pair.moving, pinned == Pinned::moving),
                tangents(pair.fixed, pinned == Pinned::fixed),
                {}};
  const Eigen::Index nu = at.along_u.cols(), nv = at.along_v.cols();
  at.jacobian.resize(static_cast<Eigen::Index>(forms.size()), nu + nv);
  for (std::size_t j = 0; j < forms.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    at.jacobian.row(row).head(nu) = (forms[j] * pair.fixed).transpose() * at.along_u;
    at.jacobian.row(row).tail(nv) = (forms[j].transpose() * pair.moving).transpose() * at.along_v;
  }
  return at;
}

Values values(std::span<const Matrix3d> forms, const PivotPair& pair) {
  Values result(static_cast<Eigen::Index>(forms.size()));
  for (std::size_t j = 0; j < forms.size(); ++j) {
    result[static_cast<Eigen::Index>(j)] = pair.moving.dot(forms[j] * pair.fixed);
  }
  return result;
}

/// The step of least length where there are fewer forms than tangents, else of least residual.
Values step(const Jacobian& jacobian, const Values& right) {
  if (jacobian.rows() < jacobian.cols()) {
    return jacobian.transpose() * (jacobian * jacobian.transpose()).ldlt().solve(right);
  }
  return jacobian.colPivHouseholderQr().solve(right);
}

PivotPair at_start(PivotPair pair, Pinned pinned) {
  if (pinned == Pinned::moving) pair.moving.z() = 0;
  if (pinned == Pinned::fixed) pair.fixed.z() = 0;
  pair.moving.normalize();
  pair.fixed.normalize();
  return pair;
}

}  // namespace

PivotPair newton(std::span<const Matrix3d> forms, const PivotPair& pair, Pinned pinned) {
  PivotPair best = at_start(pair, pinned);
  Values value = values(forms, best);
  for (int i = 0; i < kMostSteps; ++i) {
    const Linearised at = linearised(forms, best, pinned);
    const Values change = step(at.jacobian, value);
    const Eigen::Index nu = at.along_u.cols();
    PivotPair next = best;
    next.moving -= at.along_u * change.head(nu);
    next.fixed -= at.along_v * change.tail(change.size() - nu);
    next.moving.normalize();
    next.fixed.normalize();
    const Values next_value = values(forms, next);
    if (!(next_value.squaredNorm() < value.squaredNorm())) break;
    best = next;
    value = next_value;
  }
  return best;
}

double condition_of(std::span<const Matrix3d> forms, const PivotPair& pair) {
  const Linearised at = linearised(forms, pair, Pinned::none);
  const Eigen::ColPivHouseholderQR<Jacobian> qr(at.jacobian.transpose());
  const Eigen::Index n = at.jacobian.rows();
  Jacobian inverse = Jacobian::Identity(n, n);
  qr.matrixQR().topRows(n).triangularView<Eigen::Upper>().solveInPlace(inverse);
  const double condition = at.jacobian.norm() * inverse.norm();
  return std::isfinite(condition) ? condition : kWorstCondition;
}

}  // namespace cognate::synthesis
