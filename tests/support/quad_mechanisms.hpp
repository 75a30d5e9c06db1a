/// @file Mechanisms with tolerances in 113 bits by the textbook's triangles: what partials are held
/// against. They share no formula with the kernel.
#pragma once

#include <cstddef>
#include <vector>

#include "tests/support/quad_four_bar.hpp"

namespace cognate::test {

using QuadNumbers = std::vector<Quad>;

inline Quad in_radians(const Quad& degrees) {
  return degrees * boost::math::constants::pi<Quad>() / 180;
}

/// Displacement of a slider ahead of the crank's pivot along x, the guide at height `d[2]`; of
/// crank, coupler and offset.
inline Quad quad_slider(const QuadNumbers& d, const Quad& crank_angle) {
  const Quad height = d[0] * sin(crank_angle) - d[2];
  return d[0] * cos(crank_angle) + sqrt(d[1] * d[1] - height * height);
}

/// Angle of the second rocker of two four-bars in a row: crank, coupler, rocker, rod, arm, the
/// pivots at (0, 0), (`d_x`, 0) and (`g_x`, 0), both dyads open.
inline Quad quad_second_rocker(const QuadNumbers& d, const Quad& d_x, const Quad& g_x,
                               const Quad& crank_angle) {
  const auto first = quad_position({d[0], d[1], d[2], d_x, 0, 0}, crank_angle, 1);
  const Quad cx = d_x + d[2] * cos(first.rocker), cy = d[2] * sin(first.rocker);
  const Quad dx = g_x - cx, dy = -cy, square = dx * dx + dy * dy;
  const Quad along = (d[3] * d[3] - d[4] * d[4] + square) / (2 * square);
  const Quad across = sqrt(d[3] * d[3] / square - along * along);
  return atan2(Quad(cy + along * dy + across * dx), Quad(cx + along * dx - across * dy - g_x));
}

/// Angle between the line of centres and the contact of a one-way clutch, of the hub's height a,
/// the roller's radius c and the cage's radius e: cos φ = (a + c)/(e − c).
inline Quad quad_clutch(const QuadNumbers& d) {
  return acos(Quad((d[0] + d[1]) / (d[2] - d[1])));
}

/// ∂/∂d[i] by central differences, exact to some 20 digits.
template <class Function>
double quad_rate(const Function& of, const QuadNumbers& d, std::size_t i) {
  const Quad step("1e-11");
  QuadNumbers low = d, high = d;
  low[i] -= step;
  high[i] += step;
  return static_cast<double>(Quad((of(high) - of(low)) / (2 * step)));
}

}  // namespace cognate::test
