#include "synthesis/optimise/closure_hessian.hpp"

#include <ceres/jet.h>

namespace cognate::synthesis {
namespace {

using Jet = ceres::Jet<double, 5>;

/// A unit vector that turns with the parameters as `angle` says.
Vec2<Jet> turning(const Vec2d& direction, const AngleGradient<double>& angle) {
  Vec2<Jet> out{Jet(direction.x), Jet(direction.y)};
  Eigen::Matrix<double, 5, 1> slopes;
  slopes << angle.crank, angle.coupler, angle.rocker, angle.frame, angle.crank_angle;
  out.x.v = -direction.y * slopes;
  out.y.v = direction.x * slopes;
  return out;
}

AngleHessian hessian(const AngleGradient<Jet>& angle) {
  const Jet* const rows[] = {&angle.crank, &angle.coupler, &angle.rocker, &angle.frame,
                             &angle.crank_angle};
  AngleHessian out{};
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) out[i][j] = rows[i]->v[j];
  }
  return out;
}

}  // namespace

ClosureHessian closure_hessian(const Lengths<double>& links, const Vec2d& crank,
                               const LinkDirections<double>& at) {
  const auto slopes = closure_gradient(links, crank, at);
  const Lengths<Jet> lengths{Jet(links.crank, 0), Jet(links.coupler, 1), Jet(links.rocker, 2),
                             Jet(links.frame, 3)};
  LinkDirections<Jet> directions;
  directions.coupler = turning(at.coupler, slopes.coupler);
  directions.rocker = turning(at.rocker, slopes.rocker);
  const auto gradient = closure_gradient(lengths, turning(crank, {.crank_angle = 1}), directions);
  return {hessian(gradient.coupler), hessian(gradient.rocker)};
}

}  // namespace cognate::synthesis
