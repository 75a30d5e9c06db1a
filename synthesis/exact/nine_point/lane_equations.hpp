/// @file The equations of path_equations.hpp and their Newton steps, for one path in each lane.
/// Include in the kernel alone.
///
/// The rotation t of a point occurs in its two equations f and g alone, so it is eliminated: with
/// p = t ∂f/∂t and q = t ∂g/∂t the combination q f − p g leaves one row in the eight pivots, and
/// the rotation follows by least squares of the two. A pose gives two rows as they are.
#pragma once

#include "synthesis/exact/nine_point/numbers.hpp"
#include "synthesis/exact/nine_point/track_kernel.hpp"

namespace cognate::synthesis::nine_point::COGNATE_ISA {

/// Rows come with largest entries of like size. A singular system gives infinities and NaN.
class Elimination {
 public:
  static constexpr int kSize = kPivots;

  Complex rows[kSize][kSize];

  /// Replaces the rows by their factors.
  void factor() {
    for (int k = 0; k < kSize; ++k) {
      Real best = size(rows[k][k]);
      for (int i = k + 1; i < kSize; ++i) {
        const Real other = size(rows[i][k]);
        const Mask swap = other > best;
        best = larger(other, best);
        swap_[k][i] = swap;
        for (int j = k; j < kSize; ++j) exchange(swap, rows[k][j], rows[i][j]);
      }
      inverse_pivot_[k] = inverse(rows[k][k]);
      for (int i = k + 1; i < kSize; ++i) {
        const Complex factor = rows[i][k] * inverse_pivot_[k];
        rows[i][k] = factor;
        for (int j = k + 1; j < kSize; ++j) {
          rows[i][j] = subtract_product(rows[i][j], factor, rows[k][j]);
        }
      }
    }
  }

  /// Replaces the right side by the solution.
  void solve(Complex (&x)[kSize]) const {
    for (int k = 0; k < kSize; ++k) {
      for (int i = k + 1; i < kSize; ++i) exchange(swap_[k][i], x[k], x[i]);
      for (int i = k + 1; i < kSize; ++i) x[i] = subtract_product(x[i], rows[i][k], x[k]);
    }
    for (int k = kSize - 1; k >= 0; --k) {
      x[k] = x[k] * inverse_pivot_[k];
      for (int i = 0; i < k; ++i) x[i] = subtract_product(x[i], rows[i][k], x[k]);
    }
  }

 private:
  static void exchange(const Mask& swap, Complex& a, Complex& b) {
    const Complex old = a;
    a = choose(swap, b, a);
    b = choose(swap, old, b);
  }

  Complex inverse_pivot_[kSize];
  Mask swap_[kSize][kSize];
};

/// Pivots in the order of track_kernel.hpp and rotations of the points; also their changes, those
/// of a rotation being relative to it.
struct Unknowns {
  Complex pivot[kPivots];
  Complex turn[kPositions];
};

/// The data at one place of the path: rotations are those of the poses.
struct Parameters {
  Complex d[kPositions], d_bar[kPositions];
  Complex turn[kPoses], inverse_turn[kPoses];
};

/// The two equations of a position, without their gradients: index 0 is the first dyad.
struct Position {
  Complex turn, inverse_turn;
  Complex turned[2], turned_bar[2];  ///< x t and x̄/t
  Complex u[2], v[2];
  Complex value[2];
};

/// How a row came out of its two equations: row = weight[0] f + weight[1] g, and the rotation's
/// change is −(back[0] f + back[1] g) at the changed pivots. Of a pose: row e is weight[e] · f or
/// g.
struct Reduction {
  Complex weight[2], back[2];
};

class LaneEquations {
 public:
  /// `points` as in TrackTask.
  explicit LaneEquations(int points) : points_(points), poses_((kPivots - points) / 2) {}

  int points() const { return points_; }
  int poses() const { return poses_; }
  int positions() const { return poses_ + points_; }
  const Position& position(int j) const { return position_[j]; }
  const Complex& link(int dyad) const { return link_[dyad]; }
  const Complex& link_bar(int dyad) const { return link_bar_[dyad]; }

  /// Evaluates the equations.
  void evaluate(const Unknowns& at, const Parameters& data) {
    for (int e = 0; e < 2; ++e) {
      link_[e] = at.pivot[4 * e] - at.pivot[4 * e + 2];
      link_bar_[e] = at.pivot[4 * e + 1] - at.pivot[4 * e + 3];
    }
    const Complex squares[2] = {link_[0] * link_bar_[0], link_[1] * link_bar_[1]};
    for (int j = 0; j < positions(); ++j) {
      Position& here = position_[j];
      const bool pose = j < poses_;
      here.turn = pose ? data.turn[j] : at.turn[j - poses_];
      here.inverse_turn = pose ? data.inverse_turn[j] : inverse(here.turn);
      for (int e = 0; e < 2; ++e) {
        const Complex* z = at.pivot + 4 * e;
        here.turned[e] = z[0] * here.turn;
        here.turned_bar[e] = z[1] * here.inverse_turn;
        here.u[e] = here.turned[e] + (data.d[j] - z[2]);
        here.v[e] = here.turned_bar[e] + (data.d_bar[j] - z[3]);
        here.value[e] = here.u[e] * here.v[e] - squares[e];
      }
    }
  }

  /// Factors the Jacobian at the place that was evaluated last.
  void factor() {
    for (int j = 0; j < positions(); ++j) {
      const Position& here = position_[j];
      Complex gradient[2][4];
      Real sizes[2];
      for (int e = 0; e < 2; ++e) {
        Complex* g = gradient[e];
        g[0] = here.turn * here.v[e] - link_bar_[e];
        g[1] = here.inverse_turn * here.u[e] - link_[e];
        g[2] = link_bar_[e] - here.v[e];
        g[3] = link_[e] - here.u[e];
        sizes[e] = (size(g[0]) + size(g[1])) + (size(g[2]) + size(g[3]));
      }
      j < poses_ ? add_pose(j, gradient, sizes) : add_point(j, gradient, sizes);
    }
    elimination_.factor();
  }

  /// The change of the unknowns that changes the equations of position j by −value[j][·] to first
  /// order, by the Jacobian that was factored last.
  void solve(const Complex (&value)[kPositions][2], Unknowns& change) const {
    for (int j = 0; j < poses_; ++j) {
      for (int e = 0; e < 2; ++e) {
        change.pivot[2 * j + e] = -(reduction_[j].weight[e] * value[j][e]);
      }
    }
    for (int j = poses_; j < positions(); ++j) {
      const Reduction& by = reduction_[j];
      change.pivot[poses_ + j] =
          -add_product(by.weight[0] * value[j][0], by.weight[1], value[j][1]);
    }
    elimination_.solve(change.pivot);
  }

  /// The part of the change of f or g (e = 0 or 1) at position j that the pivots make, when those
  /// have changed as given; `du` and `dv` are the parts of u and v.
  Complex linear(int j, int e, const Unknowns& change, Complex& du, Complex& dv) const {
    const Position& here = position_[j];
    const Complex* z = change.pivot + 4 * e;
    du = here.turn * z[0] - z[2];
    dv = here.inverse_turn * z[1] - z[3];
    const Complex all = add_product(here.v[e] * du, here.u[e], dv);
    return subtract_product(subtract_product(all, link_bar_[e], z[0] - z[2]), link_[e],
                            z[1] - z[3]);
  }

  /// The relative change of the rotation at position j, for equations f and g at changed pivots.
  Complex turn_change(int j, const Complex& f, const Complex& g) const {
    const Reduction& by = reduction_[j];
    return -add_product(by.back[0] * f, by.back[1], g);
  }

  /// One Newton step by the factored Jacobian, from the values that were evaluated last.
  void newton(Unknowns& change) const {
    Complex value[kPositions][2];
    for (int j = 0; j < positions(); ++j) {
      for (int e = 0; e < 2; ++e) value[j][e] = position_[j].value[e];
    }
    newton(value, change);
  }

  /// The same for other values of the equations.
  void newton(const Complex (&value)[kPositions][2], Unknowns& change) const {
    solve(value, change);
    for (int j = poses_; j < positions(); ++j) {
      Complex du, dv;
      const Complex f = value[j][0] + linear(j, 0, change, du, dv);
      const Complex g = value[j][1] + linear(j, 1, change, du, dv);
      change.turn[j - poses_] = turn_change(j, f, g);
    }
  }

 private:
  void add_pose(int j, const Complex (&gradient)[2][4], const Real (&sizes)[2]) {
    for (int e = 0; e < 2; ++e) {
      const Real weight = Real(1.0) / sizes[e];
      reduction_[j].weight[e] = {weight, Real(0.0)};
      Complex* row = elimination_.rows[2 * j + e];
      for (int i = 0; i < 4; ++i) {
        row[4 * e + i] = weight * gradient[e][i];
        row[4 * (1 - e) + i] = {Real(0.0), Real(0.0)};
      }
    }
  }

  void add_point(int j, const Complex (&gradient)[2][4], const Real (&sizes)[2]) {
    const Position& here = position_[j];
    Reduction& by = reduction_[j];
    const Complex p = here.turned[0] * here.v[0] - here.turned_bar[0] * here.u[0];
    const Complex q = here.turned[1] * here.v[1] - here.turned_bar[1] * here.u[1];
    const Real back = Real(1.0) / (squared_norm(p) + squared_norm(q));
    by.back[0] = back * conjugate(p);
    by.back[1] = back * conjugate(q);
    const Real weight = Real(1.0) / (size(q) * sizes[0] + size(p) * sizes[1]);
    by.weight[0] = weight * q;
    by.weight[1] = -(weight * p);
    Complex* row = elimination_.rows[poses_ + j];
    for (int e = 0; e < 2; ++e) {
      for (int i = 0; i < 4; ++i) row[4 * e + i] = by.weight[e] * gradient[e][i];
    }
  }

  int points_, poses_;
  Complex link_[2], link_bar_[2];
  Position position_[kPositions];
  Reduction reduction_[kPositions];
  Elimination elimination_;
};

}  // namespace cognate::synthesis::nine_point::COGNATE_ISA
