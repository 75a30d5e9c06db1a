/// @file Values, corrections and conditions of roots, one in each lane. Include in the kernel
/// alone.
#pragma once

#include "synthesis/exact/nine_point/lane_equations.hpp"

namespace cognate::synthesis::nine_point::COGNATE_ISA {

class Inspector {
 public:
  explicit Inspector(const InspectTask& task) : task_(task), equations_(task.points) {
    for (int j = 0; j < equations_.positions(); ++j) {
      data_.d[j] = everywhere(task.data->d[j].at_end);
      data_.d_bar[j] = everywhere(task.data->d_bar[j].at_end);
    }
    for (int j = 0; j < equations_.poses(); ++j) {
      const Complex above = everywhere(task.data->turn_above[j].at_end);
      const Complex below = everywhere(task.data->turn_below[j].at_end);
      data_.turn[j] = above * inverse(below);
      data_.inverse_turn[j] = below * inverse(above);
    }
  }

  void run() {
    for (int first = task_.first; first < task_.last; first += kLanes) inspect(first);
  }

 private:
  static Complex everywhere(const Pair& z) { return {Real(z.re), Real(z.im)}; }

  /// Lanes beyond the last root take the last one again.
  int root_of(int first, int lane) const {
    return first + lane < task_.last ? first + lane : task_.last - 1;
  }
  Complex gather(const Pair* from, int stride, int first) const {
    double re[kLanes], im[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      const Pair& z = from[root_of(first, lane) * stride];
      re[lane] = z.re;
      im[lane] = z.im;
    }
    return {load(re), load(im)};
  }
  void scatter(const Complex& z, Pair* to, int stride, int first) const {
    double re[kLanes], im[kLanes];
    store(z.re, re);
    store(z.im, im);
    for (int lane = 0; lane < kLanes; ++lane) {
      to[root_of(first, lane) * stride] = {re[lane], im[lane]};
    }
  }

  void inspect(int first) {
    const int size = unknowns(task_.points);
    Unknowns at;
    for (int i = 0; i < kPivots; ++i) at.pivot[i] = gather(task_.roots + i, size, first);
    for (int j = 0; j < task_.points; ++j) {
      at.turn[j] = gather(task_.roots + kPivots + j, size, first);
    }
    equations_.evaluate(at, data_);
    if (task_.values) write_values(first);
    if (!task_.changes && !task_.conditions) return;
    equations_.factor();
    if (task_.changes) write_changes(first, size);
    if (task_.conditions) write_conditions(first);
  }

  void write_values(int first) const {
    for (int j = 0; j < equations_.positions(); ++j) {
      for (int e = 0; e < 2; ++e) {
        scatter(equations_.position(j).value[e], task_.values + 2 * j + e, 2 * kPositions, first);
      }
    }
  }

  void write_changes(int first, int size) const {
    Complex value[kPositions][2];
    for (int j = 0; j < equations_.positions(); ++j) {
      for (int e = 0; e < 2; ++e) {
        value[j][e] = task_.given ? gather(task_.given + 2 * j + e, 2 * kPositions, first)
                                  : equations_.position(j).value[e];
      }
    }
    Unknowns change;
    equations_.newton(value, change);
    for (int i = 0; i < kPivots; ++i) scatter(change.pivot[i], task_.changes + i, size, first);
    for (int j = 0; j < task_.points; ++j) {
      scatter(change.turn[j], task_.changes + kPivots + j, size, first);
    }
  }

  /// Adds the squares of the pivots' changes for a change of one position that changes its
  /// equations by `f` and `g`.
  void add_squares(int j, const Complex& f, const Complex& g, Real& sum) const {
    Complex value[kPositions][2];
    for (auto& pair : value) pair[0] = pair[1] = {Real(0.0), Real(0.0)};
    value[j][0] = f;
    value[j][1] = g;
    Unknowns change;
    equations_.solve(value, change);
    for (const Complex& z : change.pivot) sum = sum + squared_norm(z);
  }

  void write_conditions(int first) const {
    Real sum(0.0);
    for (int j = 0; j < equations_.positions(); ++j) {
      const Position& here = equations_.position(j);
      add_squares(j, here.v[0], here.v[1], sum);
      add_squares(j, here.u[0], here.u[1], sum);
      if (j >= equations_.poses()) continue;
      add_squares(j, here.turned[0] * here.v[0] - here.turned_bar[0] * here.u[0],
                  here.turned[1] * here.v[1] - here.turned_bar[1] * here.u[1], sum);
    }
    double squares[kLanes];
    store(sum, squares);
    for (int lane = 0; lane < kLanes; ++lane) {
      task_.conditions[root_of(first, lane)] = std::sqrt(squares[lane]);
    }
  }

  const InspectTask& task_;
  LaneEquations equations_;
  Parameters data_;
};

}  // namespace cognate::synthesis::nine_point::COGNATE_ISA
