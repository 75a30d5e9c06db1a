#include "analysis/linkage/four_bar.hpp"

#include <cmath>

namespace cognate {

Lengths<double> lengths(const FourBar& linkage) {
  const Vec2d frame = linkage.pivot_d - linkage.pivot_a;
  return {linkage.crank, linkage.coupler, linkage.rocker, std::hypot(frame.x, frame.y)};
}

double frame_angle(const FourBar& linkage) {
  const Vec2d frame = linkage.pivot_d - linkage.pivot_a;
  return std::atan2(frame.y, frame.x);
}

}  // namespace cognate
