#include "synthesis/exact/quick_return/quick_return.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/quick_return/pivot.hpp"

namespace cognate::synthesis {

ReturnAngle return_angle(double time_ratio) {
  constexpr double pi = kPi;
  const double share = (time_ratio - 1) / (time_ratio + 1);
  // π/2 − θ/2 = π/(K + 1), which keeps the cosine accurate where θ is near π.
  return {pi * share, std::sin(0.5 * pi * share), std::sin(pi / (time_ratio + 1))};
}

double pivot_condition(const ArcPoint& point, PivotGiven given, const Vec2d& place) {
  // All is symmetric: A may be taken to lie to the right and above.
  const Vec2d a{point.crank * point.coupler, point.height};
  const Vec2d from_first = a - Vec2d{-1, 0}, from_second = a - Vec2d{1, 0};
  const double first = norm(from_first), second = norm(from_second);
  const Vec2d e1 = (1 / first) * from_first, e2 = (1 / second) * from_second;
  const Vec2d angle = (1 / first) * perp(e1) - (1 / second) * perp(e2);
  Vec2d other = place;
  if (given == PivotGiven::crank) other = (0.5 / point.crank) * (e1 - e2);
  if (given == PivotGiven::coupler) other = (0.5 / point.coupler) * (e1 + e2);
  const double size = std::sqrt(squared_norm(angle) + squared_norm(other));
  return std::max(1.0, size / std::abs(cross(angle, other)) / point.coupler);
}

}  // namespace cognate::synthesis
