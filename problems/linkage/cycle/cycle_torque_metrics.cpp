/// The root mean square of the driving torque of a finished linkage, by adaptive quadrature of
/// inverse dynamics.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/cycle/cycle_scan.hpp"
#include "problems/linkage/cycle/linkage_dynamics.hpp"

namespace cognate::problems {
namespace {

/// The turn from the frame's direction on, where peaks near a change point are, cut in quarters and
/// where the rocker turns back: loads of one stroke begin and cease there.
std::vector<double> smooth_parts(LinkageDynamics& dynamics, const CycleScan& scan) {
  constexpr int kQuarters = 4;
  const auto rate = [&](double angle) {
    return dynamics.move_to(angle) ? dynamics.rocker_rate()
                                   : std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<double> ends{scan.begin};
  double before = rate(scan.begin);
  for (int k = 1; k <= CycleScan::kAngles; ++k) {
    const double here = rate(scan.angle(k));
    if (before * here < 0) {
      ends.push_back(bracket_zero(rate, scan.angle(k - 1), before, scan.angle(k), here).first);
    }
    if (k % (CycleScan::kAngles / kQuarters) == 0) ends.push_back(scan.angle(k));
    before = here;
  }
  return ends;
}

}  // namespace

double rms_torque(const FourBar& linkage, const Operation& operation) {
  constexpr unsigned kMostHalvings = 12;
  constexpr double kTolerance = 1e-12;
  LinkageDynamics dynamics(linkage, operation);
  const auto square = [&](double angle) {
    if (!dynamics.move_to(angle)) return kInfinity;
    const double torque = dynamics.driving_torque();
    return torque * torque;
  };
  const auto ends = smooth_parts(dynamics, {frame_angle(linkage)});
  double sum = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    sum += boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
        square, ends[i], ends[i + 1], kMostHalvings, kTolerance);
  }
  return std::isfinite(sum) ? std::sqrt(sum / kTurn) : kInfinity;
}

}  // namespace cognate::problems
