#include "synthesis/exact/motion/guidance_forms.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "synthesis/exact/reflections.hpp"

namespace cognate::synthesis {
namespace {

/// Which pivot is kept at infinity.
enum class Pinned { none, moving, fixed };

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
  return solved(Eigen::ColPivHouseholderQR<Jacobian>(jacobian), right);
}

PivotPair at_start(PivotPair pair, Pinned pinned) {
  if (pinned == Pinned::moving) pair.moving.z() = 0;
  if (pinned == Pinned::fixed) pair.fixed.z() = 0;
  pair.moving.normalize();
  pair.fixed.normalize();
  return pair;
}

/// A pair (u, v) of unit vectors with uᵀB_j v = 0 for the three or four forms B_j, near `pair`: for
/// three, by the least step onto the curve; for four, the solution; with a pivot pinned to
/// infinity, the least squares of four. Ends where the residual falls no further.
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

/// ‖J‖‖J⁺‖ (Frobenius) of the Jacobian of the forms by u and v, each on its unit sphere.
double condition_of(std::span<const Matrix3d> forms, const PivotPair& pair) {
  const Linearised at = linearised(forms, pair, Pinned::none);
  const Eigen::ColPivHouseholderQR<Jacobian> qr(at.jacobian.transpose());
  const Eigen::Index n = at.jacobian.rows();
  Jacobian inverse = Jacobian::Identity(n, n);
  qr.matrixQR().topRows(n).triangularView<Eigen::Upper>().solveInPlace(inverse);
  const double condition = at.jacobian.norm() * inverse.norm();
  return std::isfinite(condition) ? condition : kWorstCondition;
}

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Row = Eigen::Matrix<double, 7, 1>;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// Rounding of angles and positions as they come from a file, with a margin.
constexpr double kRounding = 16 * kEpsilon;
/// Conditions closer to dependent than this determine no digit.
constexpr double kDependent = 1e-14;
/// Below this mean turn the mean pole is so far away that the origin stays with the body.
constexpr double kLittleTurn = 0.03;
/// A homogeneous coordinate up to this times the condition, and to kFar, may be that of a pivot at
/// infinity.
constexpr double kAtInfinity = 1024 * kEpsilon;
constexpr double kFar = 1e-4;
/// Rounding of a slide that fits, relative to the extent of the poses and to their distance.
constexpr double kStraight = 64 * kEpsilon;
/// A link with more than this residual has lost it to the rounding of a pivot far away.
constexpr double kWorn = 1e-12;
/// A dyad with this residual is none.
constexpr double kLost = 1e-6;

bool finite(std::span<const Pose> poses) {
  return std::ranges::all_of(poses, [](const Pose& pose) {
    return std::isfinite(pose.at.x) && std::isfinite(pose.at.y) && std::isfinite(pose.angle);
  });
}

bool is_zero(const Displacement& to, double noise) {
  return norm(to.turn_less_one) <= kRounding && norm(to.shift) <= noise;
}

bool any_two_coincide(std::span<const Pose> poses, double noise) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      if (is_zero(displacement(poses[i], poses[j]), noise)) return true;
    }
  }
  return false;
}

/// The coefficients of (h, w₁, w₂, g₁, g₂, q₁, q₂) for a displacement d about the origin.
Row row_of(const Vec2d& d, const Vec2d& turn_less_one) {
  const Vec2d turn = turn_less_one + Vec2d{1, 0};
  const Vec2d k = turn * conj(d);
  Row row;
  row << 0.5 * squared_norm(d), k.x, -k.y, -d.x, -d.y, -turn_less_one.x, turn_less_one.y;
  return row;
}

/// Re(m q) = m.x q₁ − m.y q₂ with q = w ḡ written out in w and g.
Matrix3d form_of(const Row& row) {
  Matrix3d form;
  form << row[5], -row[6], row[1], row[6], row[5], row[2], row[3], row[4], row[0];
  return form;
}

}  // namespace

GuidanceForms::GuidanceForms(std::span<const Pose> poses)
    : poses_(poses), count_(static_cast<int>(poses.size()) - 1) {
  if (!finite(poses)) {
    status_ = GuidanceStatus::not_finite;
    return;
  }
  first_direction_ = {std::cos(poses[0].angle), std::sin(poses[0].angle)};
  std::array<Displacement, kMost> storage;
  double size = 0;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    size = std::max(size, norm(poses[j].at));
    if (j > 0) storage[j - 1] = displacement(poses[0], poses[j]);
  }
  const std::span displacements = std::span(storage).first(static_cast<std::size_t>(count_));
  const double noise = kRounding * size;
  if (any_two_coincide(poses, noise)) {
    status_ = GuidanceStatus::coincident_poses;
  } else if (std::ranges::all_of(displacements, [](const Displacement& to) {
               return norm(to.turn_less_one) <= kRounding;
             })) {
    status_ = GuidanceStatus::translation;
  }
  place(displacements);
  double farthest = 0;
  for (const Displacement& to : displacements) {
    farthest = std::max(farthest, norm(to.way(poses[0].at + origin_)));
  }
  if (status_ == GuidanceStatus::found && farthest <= noise + kRounding * norm(origin_)) {
    status_ = GuidanceStatus::rotation;
  }
  straight_ = kStraight * (1 + size / std::max(extent(poses), unit_));
  if (status_ == GuidanceStatus::found) orthogonalise(displacements);
}

/// The origin is the point that moves least, Σ|s_j + c_j o|² → min. Where the body hardly turns it
/// is far away and its distance costs digits, so it is drawn back to the body.
void GuidanceForms::place(std::span<const Displacement> displacements) {
  Vec2d product;
  double turns = 0, ways = 0;
  for (const Displacement& to : displacements) {
    product = product + conj(to.turn_less_one) * to.shift;
    turns += squared_norm(to.turn_less_one);
  }
  const double turn = std::sqrt(turns / count_);
  const double share = std::min(1.0, turn * turn / (kLittleTurn * kLittleTurn));
  origin_ = turns > 0 ? (-share / turns) * product : Vec2d{};
  for (const Displacement& to : displacements) {
    ways += squared_norm(to.way(to.about + origin_));
  }
  unit_ = std::sqrt(ways / count_) / std::max(turn, 0.1);
}

void GuidanceForms::orthogonalise(std::span<const Displacement> displacements) {
  Eigen::Matrix<double, 7, Eigen::Dynamic, 0, 7, kMost> rows(7, count_);
  for (int j = 0; j < count_; ++j) {
    const Displacement& to = displacements[static_cast<std::size_t>(j)];
    const Vec2d way = (1 / unit_) * to.way(to.about + origin_);
    const Row row = row_of(way, to.turn_less_one);
    rows.col(j) = row / row.norm();
    forms_[static_cast<std::size_t>(j)] = form_of(rows.col(j));
  }
  const Eigen::ColPivHouseholderQR<decltype(rows)> qr(rows);
  const double least = std::abs(qr.matrixQR()(count_ - 1, count_ - 1));
  if (!(least > kDependent * std::abs(qr.matrixQR()(0, 0)))) {
    status_ = GuidanceStatus::family;
    return;
  }
  const Eigen::Matrix<double, 7, 7> q = factor_q(qr);
  for (int j = 0; j < count_; ++j) basis_[static_cast<std::size_t>(j)] = form_of(q.col(j));
  null_space_ = q.rightCols<3>();
}

Vector3d GuidanceForms::moving(const Vec2d& in_body) const {
  const Vec2d at = first_direction_ * in_body - origin_;
  return Vector3d(at.x, at.y, unit_).normalized();
}

Vector3d GuidanceForms::fixed(const Vec2d& at) const {
  const Vec2d from = at - poses_[0].at - origin_;
  return Vector3d(from.x, from.y, unit_).normalized();
}

std::array<Vector3d, 2> GuidanceForms::moving_line(const Line& line) const {
  const Vec2d along = first_direction_ * line.direction;
  return {moving(line.point), Vector3d(along.x, along.y, 0)};
}

std::array<Vector3d, 2> GuidanceForms::fixed_line(const Line& line) const {
  return {fixed(line.point), Vector3d(line.direction.x, line.direction.y, 0)};
}

double GuidanceForms::residual(const PivotPair& pair) const {
  double greatest = 0;
  for (int j = 0; j < count_; ++j) {
    greatest = std::max(greatest, std::abs(pair.moving.dot(form(j) * pair.fixed)));
  }
  return greatest;
}

PivotPair GuidanceForms::refined(const PivotPair& pair) const {
  return newton(std::span(basis_).first(static_cast<std::size_t>(count_)), pair, Pinned::none);
}

/// The point of homogeneous coordinates, from the body's origin at the first pose.
Vec2d GuidanceForms::point(const Vector3d& homogeneous) const {
  const double scale = unit_ / homogeneous.z();
  return origin_ + Vec2d{scale * homogeneous.x(), scale * homogeneous.y()};
}

Vec2d GuidanceForms::body_point(const Vector3d& moving) const {
  return conj(first_direction_) * point(moving);
}

Vec2d GuidanceForms::frame_point(const Vector3d& fixed) const {
  return poses_[0].at + point(fixed);
}

/// The slide nearest to the pair: one pivot moved to infinity, the rest fitted.
GuidingDyad GuidanceForms::straightened(const PivotPair& pair, bool fixed_at_infinity) const {
  const std::span<const Matrix3d> forms(forms_.data(), static_cast<std::size_t>(count_));
  if (fixed_at_infinity) {
    const PivotPair at = newton(forms, pair, Pinned::fixed);
    return pr_dyad(poses_, body_point(at.moving), Vec2d{-at.fixed.y(), at.fixed.x()});
  }
  const PivotPair at = newton(forms, pair, Pinned::moving);
  return rp_dyad(poses_, frame_point(at.fixed),
                 conj(first_direction_) * Vec2d{-at.moving.y(), at.moving.x()});
}

/// Whether a slide is what `link`, its pivot at infinity but for rounding, or too far away to be
/// written down well, ought to be.
bool GuidanceForms::is_slide(const GuidingDyad& slide, const GuidingDyad& link,
                             bool at_infinity) const {
  if (!(link.residual <= kWorn) && !(link.residual <= slide.residual)) return true;
  return at_infinity && slide.residual <= straight_ &&
         slide.residual <= kStraight + 8 * link.residual;
}

std::optional<GuidingDyad> GuidanceForms::dyad(const PivotPair& pair) const {
  const std::span<const Matrix3d> forms(forms_.data(), static_cast<std::size_t>(count_));
  const double condition = condition_of(forms, pair);
  const double rounded = std::min(kFar, kAtInfinity * condition);
  const double fixed = std::abs(pair.fixed.z()), moving = std::abs(pair.moving.z());
  if (std::max(fixed, moving) <= rounded) return std::nullopt;
  GuidingDyad dyad = rr_dyad(poses_, body_point(pair.moving), frame_point(pair.fixed));
  if (std::min(fixed, moving) <= kFar) {
    const GuidingDyad slide = straightened(pair, fixed < moving);
    if (is_slide(slide, dyad, std::min(fixed, moving) <= rounded)) dyad = slide;
  }
  if (!(dyad.residual <= kLost) || !std::isfinite(norm(dyad.in_body) + norm(dyad.fixed))) {
    return std::nullopt;
  }
  dyad.condition = condition;
  return dyad;
}

}  // namespace cognate::synthesis
