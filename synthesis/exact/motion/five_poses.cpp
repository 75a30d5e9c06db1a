#include "synthesis/exact/motion/five_poses.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/exact/motion/conic_pair.hpp"
#include "synthesis/exact/motion/degenerate_poses.hpp"
#include "synthesis/exact/motion/guidance_forms.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Unknowns = Eigen::Matrix<double, 7, 1>;
using NullSpace = Eigen::Matrix<double, 7, 3>;

/// The residual of the normalised conditions that a dyad may have, far above rounding.
constexpr double kSolved = 1e-11;
/// Dyads whose pivots are nearer than this (in homogeneous coordinates) are one.
constexpr double kSame = 1e-9;

/// The quadratic form x_i x_j in the coordinates of the null space.
Matrix3d square_form(const NullSpace& basis, int i, int j) {
  const Matrix3d product = basis.row(i).transpose() * basis.row(j);
  return 0.5 * (product + product.transpose());
}

/// The pivots of x = (h, w, g, q) = (αβ, βw, αg, wḡ), by the larger of w and g. Empty pivots where
/// both vanish: cross slides, which hold the angle of the body.
PivotPair pivots_of(const Unknowns& x) {
  const Vec2d w{x[1], x[2]}, g{x[3], x[4]}, q{x[5], x[6]};
  const double ww = squared_norm(w), gg = squared_norm(g);
  if (gg >= ww) {
    const Vec2d u = q * g;
    return {Vector3d(u.x, u.y, gg), Vector3d(g.x, g.y, x[0])};
  }
  const Vec2d v = conj(q) * w;
  return {Vector3d(w.x, w.y, x[0]), Vector3d(v.x, v.y, ww)};
}

double apart(const Vector3d& a, const Vector3d& b) {
  return std::min((a - b).norm(), (a + b).norm());
}

/// The dyads found so far.
class Found {
 public:
  explicit Found(const GuidanceForms& forms) : forms_(forms) {}

  void add(const Unknowns& x) {
    PivotPair pair = pivots_of(x);
    if (!(pair.moving.norm() > 0) || !(pair.fixed.norm() > 0)) return;
    pair.moving.normalize();
    pair.fixed.normalize();
    pair = forms_.refined(pair);
    if (!(forms_.residual(pair) <= kSolved) || is_known(pair)) return;
    const auto dyad = forms_.dyad(pair);
    if (!dyad) return;
    pairs_[static_cast<std::size_t>(result.count)] = pair;
    result.add(*dyad);
  }

  DyadSolutions result;

 private:
  bool is_known(const PivotPair& pair) const {
    return std::any_of(pairs_.begin(), pairs_.begin() + result.count, [&](const PivotPair& known) {
      return apart(known.moving, pair.moving) + apart(known.fixed, pair.fixed) <= kSame;
    });
  }

  const GuidanceForms& forms_;
  std::array<PivotPair, 4> pairs_;
};

}  // namespace

DyadSolutions dyads_of_five_poses(std::span<const Pose, 5> poses) {
  const GuidanceForms forms(poses);
  if (forms.status() != GuidanceStatus::found) return degenerate_dyads(poses, forms.status());
  const NullSpace& n = forms.null_space();
  const auto form = [&](int i, int j) { return square_form(n, i, j); };
  // q h = w ḡ: its real and its imaginary part.
  const Matrix3d real = form(0, 5) - form(1, 3) - form(2, 4);
  const Matrix3d imaginary = form(0, 6) - form(2, 3) + form(1, 4);
  const ConicIntersection common = intersect(real, imaginary);
  Found found(forms);
  for (int k = 0; k < common.count; ++k) {
    found.add(n * common.points[static_cast<std::size_t>(k)]);
  }
  found.result.status = common.common_curve       ? GuidanceStatus::family
                        : found.result.count == 0 ? GuidanceStatus::none
                                                  : GuidanceStatus::found;
  return found.result;
}

}  // namespace cognate::synthesis
