/// @file The Taylor series of a path, and where the path goes next by it. Include in the kernel
/// alone.
///
/// All equations are products of two factors, so the coefficients of order k follow from those
/// below by convolutions and one solution with the Jacobian that Newton's method has factored
/// already.
#pragma once

#include "synthesis/exact/nine_point/lane_equations.hpp"

namespace cognate::synthesis::nine_point::COGNATE_ISA {

/// Of 4, 5, 6 and 8 the order with the least time for a path.
inline constexpr int kOrder = 6;

/// The data and how fast they change with −r; rotations of poses as series.
struct ParameterSeries {
  Complex d[kPositions], d_bar[kPositions];
  Complex turn[kPoses][kOrder + 1], inverse_turn[kPoses][kOrder + 1];
};

/// Coefficients of powers of −Δr.
class Series {
 public:
  Complex pivot[kOrder + 1][kPivots];
  Complex turn[kOrder + 1][kPositions];

  /// Of the path through `at`, where `equations` has evaluated.
  void expand(const LaneEquations& equations, const Unknowns& at, const ParameterSeries& data) {
    start(equations, at, data);
    for (int k = 1; k <= kOrder; ++k) advance(equations, data, k);
  }

 private:
  void start(const LaneEquations& equations, const Unknowns& at, const ParameterSeries& data) {
    for (int i = 0; i < kPivots; ++i) pivot[0][i] = at.pivot[i];
    for (int j = 0; j < equations.points(); ++j) turn[0][j] = at.turn[j];
    for (int e = 0; e < 2; ++e) {
      link_[e][0] = equations.link(e);
      link_bar_[e][0] = equations.link_bar(e);
    }
    for (int j = 0; j < equations.positions(); ++j) {
      const Position& here = equations.position(j);
      Factors& factors = factors_[j];
      factors.turn[0] = here.turn;
      factors.inverse_turn[0] = here.inverse_turn;
      for (int e = 0; e < 2; ++e) {
        factors.u[e][0] = here.u[e];
        factors.v[e][0] = here.v[e];
      }
      if (j >= equations.poses()) continue;
      for (int k = 0; k <= kOrder; ++k) {
        factors.turn[k] = data.turn[j][k];
        factors.inverse_turn[k] = data.inverse_turn[j][k];
      }
    }
  }

  /// Coefficient k of u, v and of the equations, as far as those below determine it: the rest is
  /// linear in the coefficients k of the unknowns.
  void known_part(const LaneEquations& equations, const ParameterSeries& data, int k, int j,
                  const Complex (&squares)[2], Complex (&value)[2]) {
    const Position& here = equations.position(j);
    Factors& by = factors_[j];
    const bool pose = j < equations.poses();
    if (!pose) {
      by.turn[k] = zero();
      Complex sum = zero();
      for (int i = 1; i < k; ++i) sum = add_product(sum, by.turn[i], by.inverse_turn[k - i]);
      by.inverse_turn[k] = -(here.inverse_turn * sum);
    }
    for (int e = 0; e < 2; ++e) {
      Complex u = k == 1 ? data.d[j] : zero(), v = k == 1 ? data.d_bar[j] : zero();
      v = add_product(v, pivot[0][4 * e + 1], by.inverse_turn[k]);
      if (pose) u = add_product(u, pivot[0][4 * e], by.turn[k]);
      for (int i = 1; i < k; ++i) {
        u = add_product(u, pivot[i][4 * e], by.turn[k - i]);
        v = add_product(v, pivot[i][4 * e + 1], by.inverse_turn[k - i]);
      }
      by.u[e][k] = u;
      by.v[e][k] = v;
      Complex sum = add_product(here.v[e] * u, here.u[e], v);
      for (int i = 1; i < k; ++i) sum = add_product(sum, by.u[e][i], by.v[e][k - i]);
      value[e] = sum - squares[e];
    }
  }

  void advance(const LaneEquations& equations, const ParameterSeries& data, int k) {
    Complex squares[2];
    for (int e = 0; e < 2; ++e) {
      squares[e] = zero();
      for (int i = 1; i < k; ++i) {
        squares[e] = add_product(squares[e], link_[e][i], link_bar_[e][k - i]);
      }
    }
    Complex value[kPositions][2];
    for (int j = 0; j < equations.positions(); ++j) {
      known_part(equations, data, k, j, squares, value[j]);
    }
    Unknowns found;
    equations.solve(value, found);
    for (int i = 0; i < kPivots; ++i) pivot[k][i] = found.pivot[i];
    for (int e = 0; e < 2; ++e) {
      link_[e][k] = found.pivot[4 * e] - found.pivot[4 * e + 2];
      link_bar_[e][k] = found.pivot[4 * e + 1] - found.pivot[4 * e + 3];
    }
    for (int j = 0; j < equations.positions(); ++j) complete(equations, found, value[j], k, j);
  }

  /// Adds to u, v and the rotation what the unknowns of order k contribute.
  void complete(const LaneEquations& equations, const Unknowns& found, const Complex (&value)[2],
                int k, int j) {
    const Position& here = equations.position(j);
    Factors& by = factors_[j];
    Complex du[2], dv[2];
    const Complex f = value[0] + equations.linear(j, 0, found, du[0], dv[0]);
    const Complex g = value[1] + equations.linear(j, 1, found, du[1], dv[1]);
    const bool pose = j < equations.poses();
    const Complex change = pose ? zero() : equations.turn_change(j, f, g);
    for (int e = 0; e < 2; ++e) {
      by.u[e][k] = by.u[e][k] + du[e];
      by.v[e][k] = by.v[e][k] + dv[e];
      if (pose) continue;
      by.u[e][k] = add_product(by.u[e][k], here.turned[e], change);
      by.v[e][k] = subtract_product(by.v[e][k], here.turned_bar[e], change);
    }
    if (pose) return;
    by.turn[k] = here.turn * change;
    by.inverse_turn[k] = subtract_product(by.inverse_turn[k], here.inverse_turn, change);
    turn[k][j - equations.poses()] = by.turn[k];
  }

  static Complex zero() { return {Real(0.0), Real(0.0)}; }

  struct Factors {
    Complex turn[kOrder + 1], inverse_turn[kOrder + 1];
    Complex u[2][kOrder + 1], v[2][kOrder + 1];
  };
  Complex link_[2][kOrder + 1], link_bar_[2][kOrder + 1];
  Factors factors_[kPositions];
};

}  // namespace cognate::synthesis::nine_point::COGNATE_ISA
