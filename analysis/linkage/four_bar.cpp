#include "analysis/linkage/four_bar.hpp"

#include <cmath>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate {

Lengths<double> lengths(const FourBar& linkage) {
  const Vec2d frame = linkage.pivot_d - linkage.pivot_a;
  return {linkage.crank, linkage.coupler, linkage.rocker, std::hypot(frame.x, frame.y)};
}

double frame_angle(const FourBar& linkage) {
  const Vec2d frame = linkage.pivot_d - linkage.pivot_a;
  return std::atan2(frame.y, frame.x);
}

Mechanism<double> as_mechanism(const FourBar& linkage) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{linkage.pivot_a, linkage.crank};
  mechanism.dyads.emplace_back(Rrr<double>{{1, {linkage.crank, 0}},
                                           {0, linkage.pivot_d},
                                           linkage.coupler,
                                           linkage.rocker,
                                           linkage.assembly});
  return mechanism;
}

}  // namespace cognate
