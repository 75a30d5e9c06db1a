#include "synthesis/fit/algebraic_dyads.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "synthesis/exact/motion/null_space_pivots.hpp"
#include "synthesis/fit/body_motion.hpp"

namespace cognate::synthesis {
namespace {

using Conditions = Eigen::Matrix<double, Eigen::Dynamic, 7>;

/// One row for each pose, about the resting point and in units of its travel, less the mean row.
Conditions conditions(std::span<const Pose> poses, const RestingPoint& rest) {
  Conditions rows(static_cast<Eigen::Index>(poses.size()), 7);
  for (Eigen::Index j = 0; j < rows.rows(); ++j) {
    const Pose& pose = poses[static_cast<std::size_t>(j)];
    const Vec2d d = (1 / rest.travel) * (to_frame(pose, rest.in_body) - rest.mean);
    const Vec2d e = unit_vector(pose.angle);
    const Vec2d turned = conj(d) * e;
    rows.row(j) << 0.5 * squared_norm(d), turned.x, -turned.y, -d.x, -d.y, -e.x, e.y;
  }
  rows.rowwise() -= rows.colwise().mean().eval();
  return rows;
}

}  // namespace

std::vector<GuidingDyad> algebraic_dyads(std::span<const Pose> poses) {
  std::vector<GuidingDyad> dyads;
  if (poses.size() < 5) return dyads;
  const RestingPoint rest = resting_point(poses);
  if (!(rest.travel > 0)) return dyads;
  const Conditions rows = conditions(poses, rest);
  if (!rows.allFinite()) return dyads;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  const PivotNullSpace basis = svd.matrixV().rightCols<3>();
  const NullSpacePivots found = pivots_of_null_space(basis);
  constexpr double kFarAway = 1e-6;  // of homogeneous coordinates; beyond, a link is a slide
  for (int k = 0; k < found.count; ++k) {
    const auto& [moving, fixed] = found.pairs[static_cast<std::size_t>(k)];
    if (std::abs(moving[2]) < kFarAway || std::abs(fixed[2]) < kFarAway) continue;
    const Vec2d w{moving[0] / moving[2], moving[1] / moving[2]};
    const Vec2d g{fixed[0] / fixed[2], fixed[1] / fixed[2]};
    dyads.push_back(rr_dyad(poses, rest.in_body + rest.travel * w, rest.mean + rest.travel * g));
  }
  return dyads;
}

}  // namespace cognate::synthesis
