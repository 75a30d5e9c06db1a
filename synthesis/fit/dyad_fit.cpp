#include "synthesis/fit/dyad_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <array>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "synthesis/fit/body_motion.hpp"

namespace cognate::synthesis {
namespace {

/// Least squares n·d ≈ c − Re(n̄ e m) for any n at once: the regression of the places d on 1, cos θ
/// and sin θ.
class SlideRegression {
 public:
  explicit SlideRegression(std::span<const Pose> poses)
      : rest_(resting_point(poses)), unit_(rest_.travel > 0 ? rest_.travel : 1) {
    const auto count = static_cast<Eigen::Index>(poses.size());
    Eigen::MatrixXd basis(count, 3), places(count, 2);
    for (Eigen::Index j = 0; j < count; ++j) {
      const Pose& pose = poses[static_cast<std::size_t>(j)];
      const Vec2d d = (1 / unit_) * (to_frame(pose, rest_.in_body) - rest_.mean);
      basis.row(j) << 1, std::cos(pose.angle), std::sin(pose.angle);
      places.row(j) << d.x, d.y;
    }
    coefficients_ = basis.completeOrthogonalDecomposition().solve(places);
    rest_squares_ = (places - basis * coefficients_).transpose() * (places - basis * coefficients_);
  }

  /// The normal of the slide line for which least is left.
  Vec2d best_normal() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(rest_squares_);
    const Eigen::Vector2d n = solver.eigenvectors().col(0);
    return {n[0], n[1]};
  }

  /// The body's point for a normal, and c: how far the line lies along it from the origin.
  std::pair<Vec2d, double> point_and_offset(const Vec2d& normal) const {
    const Eigen::Vector3d k = coefficients_ * Eigen::Vector2d(normal.x, normal.y);
    const Vec2d from_rest = unit_ * (normal * Vec2d{-k[1], k[2]});
    return {rest_.in_body + from_rest, unit_ * k[0] + dot(normal, rest_.mean)};
  }

 private:
  RestingPoint rest_;
  double unit_;
  Eigen::Matrix<double, 3, 2> coefficients_;
  Eigen::Matrix2d rest_squares_;
};

GuidingDyad slider_of(std::span<const Pose> poses, const SlideRegression& regression,
                      const Vec2d& normal) {
  const auto [in_body, offset] = regression.point_and_offset(normal);
  GuidingDyad dyad = pr_dyad(poses, in_body, -perp(normal));
  dyad.fixed = dyad.fixed + (offset - dot(normal, dyad.fixed)) * normal;
  return dyad;
}

/// The block of the body that is the slider of `inverted`, a fit to the inverse motion.
GuidingDyad as_block(const GuidingDyad& inverted, std::span<const Pose> poses) {
  GuidingDyad block = rp_dyad(poses, inverted.in_body, inverted.direction);
  block.in_body = inverted.fixed;
  return block;
}

/// Across the line of a dyad that slides.
Vec2d normal_of(const GuidingDyad& dyad) {
  return perp(dyad.direction);
}

}  // namespace

LinkModel::LinkModel(std::span<const Pose> poses, double unit) {
  for (const Pose& pose : poses) {
    at_.push_back(pose.at);
    direction_.push_back(unit_vector(pose.angle));
  }
  const double far = kReach * unit;
  variables_ = {Variable{"moving pivot u", -far, far, unit},
                {"moving pivot v", -far, far, unit},
                {"fixed pivot x", -far, far, unit},
                {"fixed pivot y", -far, far, unit},
                {"length", 0, far, unit}};
}

bool LinkModel::residuals(std::span<const double> x, std::span<double> r,
                          std::span<double> jacobian, std::span<double>) const {
  const Vec2d moving{x[0], x[1]}, fixed{x[2], x[3]};
  for (std::size_t j = 0; j < at_.size(); ++j) {
    const Vec2d arm = at_[j] + direction_[j] * moving - fixed;
    const double distance = norm(arm);
    if (!(distance > 0)) return false;
    r[j] = distance - x[4];
    if (jacobian.empty()) continue;
    const Vec2d along = (1 / distance) * arm;
    const Vec2d in_body = conj(direction_[j]) * along;
    const std::array<double, 5> slopes{in_body.x, in_body.y, -along.x, -along.y, -1};
    for (std::size_t i = 0; i < slopes.size(); ++i) jacobian[5 * j + i] = slopes[i];
  }
  return true;
}

double squared_misfit(const GuidingDyad& dyad, std::span<const Pose> poses) {
  double sum = 0;
  for (const Pose& pose : poses) {
    double miss = 0;
    switch (dyad.kind) {
      case DyadKind::rr:
        miss = norm(to_frame(pose, dyad.in_body) - dyad.fixed) - dyad.length;
        break;
      case DyadKind::pr:
        miss = dot(normal_of(dyad), to_frame(pose, dyad.in_body) - dyad.fixed);
        break;
      case DyadKind::rp:
        miss = dot(normal_of(dyad), to_body(pose, dyad.fixed) - dyad.in_body);
        break;
    }
    sum += miss * miss;
  }
  return sum;
}

std::optional<GuidingDyad> nearest_link(const GuidingDyad& start, std::span<const Pose> poses,
                                        const Options& options) {
  const RestingPoint rest = resting_point(poses);
  const double unit = rest.travel > 0 ? rest.travel : 1;
  std::vector<Pose> near;  // about the resting point, so that bounds are about it
  for (const Pose& pose : poses) {
    near.push_back({to_frame(pose, rest.in_body) - rest.mean, pose.angle});
  }
  const LinkModel model(near, unit);
  const Vec2d moving = start.in_body - rest.in_body, fixed = start.fixed - rest.mean;
  const std::array<double, 5> x{moving.x, moving.y, fixed.x, fixed.y, start.length};
  const Solution solution = solve(Solver::gauss_newton, model, x, options);
  if (solution.stop == Stop::no_value) return std::nullopt;
  constexpr double kLost = 0.5 * LinkModel::kReach;
  for (const double value : solution.x) {
    if (!(std::abs(value) < kLost * unit)) return std::nullopt;
  }
  return rr_dyad(poses, rest.in_body + Vec2d{solution.x[0], solution.x[1]},
                 rest.mean + Vec2d{solution.x[2], solution.x[3]});
}

GuidingDyad nearest_slider(std::span<const Pose> poses) {
  const SlideRegression regression(poses);
  return slider_of(poses, regression, regression.best_normal());
}

GuidingDyad nearest_block(std::span<const Pose> poses) {
  return as_block(nearest_slider(inverse_motion(poses)), poses);
}

GuidingDyad slider_along(std::span<const Pose> poses, const Vec2d& direction) {
  return slider_of(poses, SlideRegression(poses), perp(direction));
}

GuidingDyad block_along(std::span<const Pose> poses, const Vec2d& direction) {
  return as_block(slider_along(inverse_motion(poses), direction), poses);
}

}  // namespace cognate::synthesis
