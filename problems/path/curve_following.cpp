#include "problems/path/curve_following.hpp"

#include <algorithm>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// What a coupler curve may leave the target by: so many times what samples of the target are off,
/// or so much of the target's length. Between samples that are a hundredth of the length apart,
/// corners of the target are cut by no more.
constexpr double kTimesTheError = 3, kShareOfLength = 5e-3;

}  // namespace

double curve_deviation(const ClosedCurve& curve, const FourBar& linkage,
                       const CurvePlacement& placement, int positions) {
  const Motion motion(linkage);
  double greatest = 0;
  for (int k = 0; k < positions; ++k) {
    // Where rounding denies a position at a change point, its neighbours suffice.
    const auto pose = motion.at(kTurn * k / positions);
    if (!pose || !pose->coupler_point) continue;
    greatest = std::max(greatest, curve.distance(placement.point_back(*pose->coupler_point)));
  }
  return greatest;
}

ConstraintCheck check_extra_loop(const ClosedCurve& curve, double deviation, double error_max) {
  const double most = std::max(kTimesTheError * error_max, kShareOfLength * curve.length());
  return {"no_extra_loop", deviation, Range{0, most}, deviation <= most};
}

}  // namespace cognate::problems
