#include "synthesis/fit/circle.hpp"

#include <cmath>

namespace cognate::synthesis {

std::optional<Circle> algebraic_circle(std::span<const Vec2d> points) {
  if (points.size() < 3) return std::nullopt;
  const double share = 1 / static_cast<double>(points.size());
  Vec2d mean{};
  for (const Vec2d& point : points) mean = mean + share * point;
  // About the mean, 2 Σ z zᵀ c = Σ z |z|² and r² = |c|² + the mean of |z|².
  double xx = 0, xy = 0, yy = 0;
  Vec2d cubes{};
  for (const Vec2d& point : points) {
    const Vec2d z = point - mean;
    xx += z.x * z.x;
    xy += z.x * z.y;
    yy += z.y * z.y;
    cubes = cubes + squared_norm(z) * z;
  }
  const double determinant = xx * yy - xy * xy;
  constexpr double kStraight = 1e-13;  // of the points' spread across their line, squared
  if (!(determinant > kStraight * (xx + yy) * (xx + yy))) return std::nullopt;
  const Vec2d centre =
      (0.5 / determinant) * Vec2d{yy * cubes.x - xy * cubes.y, xx * cubes.y - xy * cubes.x};
  return Circle{mean + centre, std::sqrt(squared_norm(centre) + share * (xx + yy))};
}

}  // namespace cognate::synthesis
