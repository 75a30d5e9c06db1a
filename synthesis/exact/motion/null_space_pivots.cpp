#include "synthesis/exact/motion/null_space_pivots.hpp"

#include "analysis/numbers/vec2.hpp"
#include "synthesis/exact/motion/conic_pair.hpp"

namespace cognate::synthesis {
namespace {

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
