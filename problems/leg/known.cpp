#include "problems/leg/known.hpp"

#include <cmath>

#include "analysis/numbers/vec2.hpp"

namespace cognate::problems {
namespace {

/// The third point of a triangle in the axes from `first` towards `second`, `base` apart: so far
/// from both, to the `side` of the way.
Vec2d corner(double base, double from_first, double from_second, int side) {
  const double along =
      (base * base + (from_first - from_second) * (from_first + from_second)) / (2 * base);
  return {along, side * std::sqrt((from_first - along) * (from_first + along))};
}

synthesis::ChainDesign scaled_to_stride(synthesis::ChainDesign published, double stride) {
  for (double& parameter : published.parameters) parameter /= stride;
  return published;
}

/// O, A, B, M, C, D, E, F.
synthesis::ChainDesign klann() {
  const Vec2d d = corner(0.59, 1.1051, 0.5221, -1), f = corner(0.8966, 0.8966, 1.732, -1);
  constexpr double kX = 1.599, kY = 0.75;  // of the crank's pivot
  return scaled_to_stride({{0, 0, 1.009 - kX, 0.574 - kY, 1.366 - kX, 1.366 - kY, 0.268, 0.59,
                            0.3206, d.x, d.y, 0.8966, 0.5177, f.x, f.y},
                           {0, 0, 0, 0, -1, 0, 1, 0}},
                          1.0087);
}

/// O, B, M, C, E, D, F, P.
synthesis::ChainDesign jansen() {
  const Vec2d e = corner(41.5, 40.1, 55.8, 1), p = corner(36.7, 65.7, 49, -1);
  return scaled_to_stride(
      {{0, 0, -38, -7.8, 15, 50, 41.5, e.x, e.y, 61.9, 39.3, 39.4, 36.7, p.x, p.y},
       {0, 0, 0, -1, 0, 1, -1, 0}},
      67.88);
}

}  // namespace

std::optional<synthesis::ChainDesign> known_leg(std::string_view topology) {
  if (topology == "klann") return klann();
  if (topology == "jansen") return jansen();
  return std::nullopt;
}

}  // namespace cognate::problems
