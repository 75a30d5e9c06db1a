/// @file The four-bar by the textbook's triangle in 113 bits: what tolerances are held against. It
/// shares no formula with the kernel.
#pragma once

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <span>

namespace cognate::test {

using Quad = boost::multiprecision::cpp_bin_float_quad;

/// crank, coupler, rocker, frame (along x, the crank's pivot at the origin), and the coupler point.
using QuadDimensions = std::array<Quad, 6>;

struct QuadPosition {
  Quad rocker;  ///< its angle from the x axis
  Quad x, y;    ///< of the coupler point
};

/// `side`: +1 open. By the cosine rule in the triangle B, C, D.
inline QuadPosition quad_position(const QuadDimensions& d, const Quad& crank_angle, int side) {
  const auto& [r, c, k, f, u, v] = d;
  const Quad bx = r * cos(crank_angle), by = r * sin(crank_angle);
  const Quad dx = f - bx, dy = -by, square = dx * dx + dy * dy;
  const Quad along = (c * c - k * k + square) / (2 * square);
  const Quad across = side * sqrt(c * c / square - along * along);
  const Quad cx = bx + along * dx - across * dy, cy = by + along * dy + across * dx;
  const Quad ex = (cx - bx) / c, ey = (cy - by) / c;
  return {atan2(cy, cx - f), bx + u * ex - v * ey, by + u * ey + v * ex};
}

/// ∂(rocker angle)/∂(dimension i), by central differences in 113 bits: exact to some 20 digits.
inline Quad quad_rocker_rate(const QuadDimensions& d, int i, const Quad& crank_angle, int side) {
  const Quad step("1e-11");
  QuadDimensions low = d, high = d;
  low[static_cast<std::size_t>(i)] -= step;
  high[static_cast<std::size_t>(i)] += step;
  const Quad change =
      quad_position(high, crank_angle, side).rocker - quad_position(low, crank_angle, side).rocker;
  return change / (2 * step);
}

/// Calls `visit` with every corner of the box of half width t about d, over the first `count`
/// dimensions.
template <class Visit>
void each_corner(const QuadDimensions& d, const Quad& t, int count, const Visit& visit) {
  for (int corner = 0; corner < (1 << count); ++corner) {
    QuadDimensions at = d;
    for (int i = 0; i < count; ++i) {
      at[static_cast<std::size_t>(i)] += (corner >> i) % 2 == 1 ? t : Quad(-t);
    }
    visit(at);
  }
}

}  // namespace cognate::test
