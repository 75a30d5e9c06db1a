/// @file The distances of a chain's point from its targets for many chains at a time, one in each
/// SIMD lane: the problem of a LaneFit. Include in kernels alone.
///
/// The crank angle of a free point touches its own two residuals alone: with τ the direction of
/// the path there, what is across it stays as one row, and the angle follows by −τ·(r + J dx)/|P′|
/// (orthogonal distance regression: Boggs, Byrd & Schnabel 1987, "A stable and efficient algorithm
/// for nonlinear orthogonal distance regression"). Of a pose's three
/// residuals two rows stay, those across the way of all three.
#pragma once

#include "synthesis/chain/chain_fit_kernel.hpp"
#include "synthesis/chain/crank_angle_lanes.hpp"
#include "synthesis/chain/heading.hpp"
#include "synthesis/chain/pose_lanes.hpp"
#include "synthesis/chain/sweep.hpp"
#include "synthesis/lanes/lane_fit.hpp"

namespace cognate::synthesis::COGNATE_ISA {

class ChainLanes {
 public:
  static constexpr int kMostUnknowns = kMostChainParameters + 1;
  using Equations = NormalEquations<kMostUnknowns>;

  explicit ChainLanes(const ChainFitTask& task) : task_(task), timed_(task.crank_x != nullptr) {
    double* next = task.workspace;
    for (double** array : {&angle_, &next_angle_, &crank_, &next_crank_}) {
      *array = next;
      next += 2L * task.points * kLanes;
    }
    idle();
  }

  /// The phase of a timed path is the last unknown.
  int unknowns() const { return task_.unknowns + timed_; }

  bool take(int lane) {
    if (next_start_ >= task_.starts) return false;
    const int start = next_start_++;
    start_of_[lane] = start;
    const double* parameter = task_.parameter + long(start) * task_.parameters;
    for (int i = 0; i < task_.parameters; ++i) set_lane(here_[i], lane, parameter[i]);
    for (int i = 0; i < task_.unknowns; ++i) {
      const double from = parameter[task_.unknown[i]], low = task_.lower[i], high = task_.upper[i];
      set_lane(here_[task_.unknown[i]], lane, from < low ? low : from > high ? high : from);
    }
    for (int k = 0; k < task_.lines; ++k) {
      set_lane(side_[k], lane, task_.side[long(start) * task_.lines + k]);
    }
    const double* angle = task_.angle + long(start) * angles();
    for (int j = 0; j < angles(); ++j) put_angle(j, lane, angle[j]);
    return true;
  }

  void give(int lane, double cost, int iterations) {
    const int start = start_of_[lane];
    double* parameter = task_.parameter + long(start) * task_.parameters;
    for (int i = 0; i < task_.parameters; ++i) parameter[i] = lane_of(here_[i], lane);
    double* angle = task_.angle + long(start) * angles();
    for (int j = 0; j < angles(); ++j) angle[j] = angle_[j * kLanes + lane];
    task_.cost[start] = cost;
    task_.iterations[start] = iterations;
  }

  Real lowest_step(int i) const {
    return i < task_.unknowns ? Real(task_.lower[i]) - here_[task_.unknown[i]] : Real(-kMostTurn);
  }
  Real highest_step(int i) const {
    return i < task_.unknowns ? Real(task_.upper[i]) - here_[task_.unknown[i]] : Real(kMostTurn);
  }

  bool is_hopeless(double cost, int iterations) const {
    return (iterations == task_.early && cost > task_.early_cost) ||
           (iterations == task_.late && cost > task_.late_cost);
  }

  void linearise(Equations& equations) {
    equations.clear(unknowns());
    along_ = Real(0.0);
    const View chain = view(here_), limited = upto_joints(chain);
    for (int j = 0; j < task_.points; ++j) {
      place_at(j, chain, crank_);
      is_motion() ? add_pose(chain, j, equations) : add_point(chain, j, equations);
      if (task_.checks == 0) add_transmission(chain, equations);
    }
    for (int i = 0; i < task_.checks; ++i) {
      place_at_check(i, limited);
      add_transmission(chain, equations);
    }
  }

  /// Crank angles have been eliminated by `linearise`; what their own steps gain.
  Real reduce(const Real& damping, Equations&) const {
    const Real share = Real(1.0) / (Real(1.0) + damping);
    return along_ * share * (Real(2.0) - share);
  }

  void attempt(const Real* step, const Real& damping) {
    for (int i = 0; i < task_.parameters; ++i) {
      next_[i] = here_[i];
      rate_[i] = Real(0.0);
    }
    for (int i = 0; i < task_.unknowns; ++i) {
      const int which = task_.unknown[i];
      rate_[which] = step[i];
      next_[which] =
          larger(Real(task_.lower[i]), smaller(Real(task_.upper[i]), here_[which] + step[i]));
    }
    if (timed_) {
      turn_all(step[task_.unknowns]);
    } else {
      turn_each(damping);
    }
  }

  Real cost() {
    const View chain = view(next_), limited = upto_joints(chain);
    Real sum(0.0);
    for (int j = 0; j < task_.points; ++j) {
      place_at(j, chain, next_crank_);
      sum = sum + (is_motion() ? squared_pose_error(chain, j)
                               : squared_norm(weight(j) * (place_.at[task_.trace] - target(j))));
      if (task_.checks == 0) sum = sum + transmission_cost(chain);
    }
    for (int i = 0; i < task_.checks; ++i) {
      place_at_check(i, limited);
      if (i == 0) note_drawn();
      sum = sum + transmission_cost(chain);
    }
    return sum;
  }

  void keep(const Mask& lanes) {
    for (int i = 0; i < task_.parameters; ++i) here_[i] = choose(lanes, next_[i], here_[i]);
    keep(lanes, next_angle_, angle_, angles());
    keep(lanes, next_crank_, crank_, 2 * (timed_ ? 1 : task_.points));
  }

 private:
  using View = ChainView<Real>;

  static constexpr double kMostTurn = 0.3;  ///< of a crank angle in one step

  int angles() const { return timed_ ? 1 : task_.points; }
  View view(const Real* parameters) const { return {task_.line, task_.lines, parameters, side_}; }
  bool is_motion() const { return task_.heading >= 0; }
  Real weight(int j) const { return Real(task_.root_weight[j]); }
  Direction target(int j) const { return {Real(task_.target_x[j]), Real(task_.target_y[j])}; }
  Direction check(int i) const { return {Real(task_.check_x[i]), Real(task_.check_y[i])}; }

  /// Lanes without a start hold numbers that no arithmetic stops at.
  void idle() {
    for (int i = 0; i < task_.parameters; ++i) here_[i] = Real(1.0);
    for (int k = 0; k < task_.lines; ++k) side_[k] = Real(1.0);
    for (int j = 0; j < angles(); ++j) {
      for (int lane = 0; lane < kLanes; ++lane) put_angle(j, lane, 0);
    }
  }

  void put_angle(int j, int lane, double angle) {
    angle_[j * kLanes + lane] = next_angle_[j * kLanes + lane] = angle;
    for (double* array : {crank_, next_crank_}) {
      array[2 * j * kLanes + lane] = std::cos(angle);
      array[(2 * j + 1) * kLanes + lane] = std::sin(angle);
    }
  }

  /// The direction of the crank at point j; of a timed path `array` holds that of the phase.
  Direction crank_at(int j, const double* array) const {
    const int from = timed_ ? 0 : 2 * j * kLanes;
    const Direction own{load(array + from), load(array + from + kLanes)};
    return timed_ ? own * Direction{Real(task_.crank_x[j]), Real(task_.crank_y[j])} : own;
  }

  /// Without the lines that no joint depends on.
  View upto_joints(View chain) const {
    chain.count = 0;
    for (int i = 0; i < task_.joints; ++i) {
      if (task_.joint[i] >= chain.count) chain.count = task_.joint[i] + 1;
    }
    return chain;
  }

  void place_at(int j, const View& chain, const double* cranks) {
    const Direction crank = crank_at(j, cranks);
    j == 0 ? place(chain, crank, place_) : place<Kept::distances>(chain, crank, place_);
  }

  /// The first check is at angle 0, where three-pin links are drawn.
  void place_at_check(int i, const View& chain) {
    const bool begins = i == 0 && has_three_pin_link(chain);
    begins ? place_lines<Kept::guides>(chain, check(i), place_)
           : place<Kept::distances>(chain, check(i), place_);
  }

  /// Three-pin links are drawn where they stand with the dimensions attempted.
  void note_drawn() {
    for (int k = 0; k < task_.lines; ++k) {
      const auto& [line, parameter] = task_.line[k];
      if (line.type != LineType::drawn) continue;
      const Direction at = place_.at[k + kFirstPin - kDrawnLine];
      next_[parameter] = at.x;
      next_[parameter + 1] = at.y;
    }
  }

  void keep(const Mask& lanes, const double* from, double* to, int count) const {
    for (int i = 0; i < count; ++i) {
      store(choose(lanes, load(from + i * kLanes), load(to + i * kLanes)), to + i * kLanes);
    }
  }

  /// The derivatives of `direction`·P by the unknowns; returns that by the crank's angle.
  Real row_of(const View& chain, const Direction& direction, Real* row) {
    for (int i = 0; i < task_.parameters; ++i) gradient_[i] = Real(0.0);
    for (int k = 0; k < task_.trace; ++k) seed_[k] = {Real(0.0), Real(0.0)};
    seed_[task_.trace] = direction;
    const Real turn = sweep_back(chain, place_, task_.trace, seed_, gradient_);
    for (int i = 0; i < task_.unknowns; ++i) row[i] = gradient_[task_.unknown[i]];
    return turn;
  }

  void add_point(const View& chain, int j, Equations& equations) {
    timed_ ? add_timed(chain, j, equations) : add_free(chain, j, equations);
  }

  void add_timed(const View& chain, int j, Equations& equations) {
    const Real own = weight(j), zero(0.0);
    const Direction error = own * (place_.at[task_.trace] - target(j));
    Real row[kMostUnknowns];
    row[task_.unknowns] = row_of(chain, {own, zero}, row);
    equations.add(error.x, row, unknowns());
    row[task_.unknowns] = row_of(chain, {zero, own}, row);
    equations.add(error.y, row, unknowns());
  }

  void add_free(const View& chain, int j, Equations& equations) {
    move_by_crank(chain);
    const Direction path = velocity_[task_.trace], error = place_.at[task_.trace] - target(j);
    const Direction along = (Real(1.0) / (root(squared_norm(path)) + Real(1e-300))) * path;
    Real row[kMostUnknowns];
    row_of(chain, weight(j) * perp(along), row);
    equations.add(weight(j) * cross(along, error), row, task_.unknowns);
    add_along(weight(j) * dot(along, error), equations);
  }

  /// The part of an error that the crank's own step takes away.
  void add_along(const Real& error, Equations& equations) {
    equations.cost = equations.cost + error * error;
    along_ = along_ + error * error;
  }

  void move_by_crank(const View& chain) {
    move(chain, place_, Real(1.0), static_cast<const Real*>(nullptr), velocity_);
  }

  PoseError pose_error(const View& chain, int j) const {
    return synthesis::COGNATE_ISA::pose_error(task_, chain, place_, j);
  }

  Real squared_pose_error(const View& chain, int j) const {
    const Residual error = pose_error(chain, j).residual;
    return dot(error, error);
  }

  Residual pose_rate(const View& chain, int j, const Real& slope, const Real& own) const {
    const Direction path = weight(j) * velocity_[task_.trace];
    return {path.x, path.y, slope * heading_rate(chain, place_, task_.heading, velocity_, own)};
  }

  /// The derivatives of `direction`·residual by the unknowns; returns that by the crank's angle.
  Real row_of_pose(const View& chain, int j, const Residual& direction, const Real& slope,
                   Real* row) {
    for (int i = 0; i < task_.parameters; ++i) gradient_[i] = Real(0.0);
    for (int k = 0; k < task_.trace; ++k) seed_[k] = {Real(0.0), Real(0.0)};
    seed_[task_.trace] = weight(j) * Direction{direction.x, direction.y};
    seed_heading(chain, place_, task_.heading, slope * direction.turn, seed_, gradient_);
    const Real turn = sweep_back(chain, place_, task_.trace, seed_, gradient_);
    for (int i = 0; i < task_.unknowns; ++i) row[i] = gradient_[task_.unknown[i]];
    return turn;
  }

  void add_pose(const View& chain, int j, Equations& equations) {
    const PoseError error = pose_error(chain, j);
    timed_ ? add_timed_pose(chain, j, error, equations) : add_free_pose(chain, j, error, equations);
  }

  void add_timed_pose(const View& chain, int j, const PoseError& error, Equations& equations) {
    const Real zero(0.0), one(1.0);
    const Residual axes[] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    Real row[kMostUnknowns];
    for (const Residual& axis : axes) {
      row[task_.unknowns] = row_of_pose(chain, j, axis, error.slope, row);
      equations.add(dot(axis, error.residual), row, unknowns());
    }
  }

  void add_free_pose(const View& chain, int j, const PoseError& error, Equations& equations) {
    move_by_crank(chain);
    const Residual rate = pose_rate(chain, j, error.slope, Real(0.0));
    const Residual along = (Real(1.0) / (root(dot(rate, rate)) + Real(1e-300))) * rate;
    Residual kept[2];
    across(along, choose(along.turn < Real(0.0), Real(-1.0), Real(1.0)), kept[0], kept[1]);
    Real row[kMostUnknowns];
    for (const Residual& direction : kept) {
      row_of_pose(chain, j, direction, error.slope, row);
      equations.add(dot(direction, error.residual), row, task_.unknowns);
    }
    add_along(dot(along, error.residual), equations);
  }

  /// Not a number where the cosine is none: a chain that does not close has no cost.
  Real excess(const Real& cosine) const {
    const Real beyond = magnitude(cosine) - Real(task_.cosine_limit);
    return Real(task_.penalty) * choose(beyond <= Real(0.0), Real(0.0), beyond);
  }

  void add_transmission(const View& chain, Equations& equations) {
    for (int i = 0; i < task_.joints; ++i) {
      const int k = task_.joint[i];
      const Real cosine = transmission_cosine(chain, place_, k), beyond = excess(cosine);
      if (!any(beyond > Real(0.0))) continue;
      for (int n = 0; n < task_.parameters; ++n) gradient_[n] = Real(0.0);
      const int last = last_seeded(chain, k);
      for (int n = 0; n <= last || n <= k; ++n) seed_[n] = {Real(0.0), Real(0.0)};
      const Real sign = choose(cosine > Real(0.0), Real(1.0), Real(-1.0));
      const Real slope = choose(beyond > Real(0.0), sign * Real(task_.penalty), Real(0.0));
      seed_transmission(chain, place_, k, cosine, slope, seed_, gradient_);
      sweep_back(chain, place_, last, seed_, gradient_);
      Real row[kMostUnknowns];
      for (int n = 0; n < task_.unknowns; ++n) row[n] = gradient_[task_.unknown[n]];
      if (timed_) row[task_.unknowns] = Real(0.0);
      equations.add(beyond, row, unknowns());
    }
  }

  Real transmission_cost(const View& chain) const {
    Real sum(0.0);
    for (int i = 0; i < task_.joints; ++i) {
      const Real beyond = excess(transmission_cosine(chain, place_, task_.joint[i]));
      sum = sum + beyond * beyond;
    }
    return sum;
  }

  void turn_all(const Real& step) {
    store(load(angle_) + Real(2.0) * half_angle(step), next_angle_);
    const Direction now = turned({load(crank_), load(crank_ + kLanes)}, Real(0.5) * step);
    const Direction next = turned(now, Real(0.5) * step);
    store(next.x, next_crank_);
    store(next.y, next_crank_ + kLanes);
  }

  /// Of the crank, to where the point is nearest to target j once the dimensions have changed.
  Real step_to_point(const View& chain, int j) {
    move_by_crank(chain);
    const Direction path = velocity_[task_.trace];
    move(chain, place_, Real(0.0), rate_, velocity_);
    const Direction ahead = place_.at[task_.trace] - target(j) + velocity_[task_.trace];
    return -dot(path, ahead) / (squared_norm(path) + Real(1e-300));
  }

  /// The same of pose j.
  Real step_to_pose(const View& chain, int j) {
    const auto [error, slope] = pose_error(chain, j);
    move_by_crank(chain);
    const Residual path = pose_rate(chain, j, slope, Real(0.0));
    move(chain, place_, Real(0.0), rate_, velocity_);
    const Residual by = pose_rate(chain, j, slope, rate_[task_.line[task_.heading].parameter]);
    return -(dot(path, error) + dot(path, by)) / (dot(path, path) + Real(1e-300));
  }

  void turn_each(const Real& damping) {
    const View chain = view(here_);
    const Real share = Real(1.0) / (Real(1.0) + damping);
    for (int j = 0; j < task_.points; ++j) {
      place_at(j, chain, crank_);
      const Real step = share * (is_motion() ? step_to_pose(chain, j) : step_to_point(chain, j));
      const Real turn = larger(Real(-kMostTurn), smaller(Real(kMostTurn), step));
      store(load(angle_ + j * kLanes) + turn, next_angle_ + j * kLanes);
    }
    keep_order(angle_, next_angle_, next_crank_, task_.points, task_.closed);  // cranks follow
    for (int j = 0; j < task_.points; ++j) {
      const Real turn = load(next_angle_ + j * kLanes) - load(angle_ + j * kLanes);
      const double* from = crank_ + 2 * j * kLanes;
      double* to = next_crank_ + 2 * j * kLanes;
      const Direction next = Direction{load(from), load(from + kLanes)} * small_rotation(turn);
      store(next.x, to);
      store(next.y, to + kLanes);
    }
  }

  const ChainFitTask& task_;
  const bool timed_;
  int next_start_ = 0;
  int start_of_[kLanes] = {};
  double *angle_, *next_angle_;  ///< of the crank at each point, or the phase
  double *crank_, *next_crank_;  ///< their directions
  Real here_[kMostChainParameters], next_[kMostChainParameters], rate_[kMostChainParameters];
  Real side_[kMostLines], gradient_[kMostChainParameters];
  Real along_ = Real(0.0);  ///< what the angles' own steps gain
  Direction seed_[kMostLines], velocity_[kMostLines];
  ChainPlace<Real> place_;
};

}  // namespace cognate::synthesis::COGNATE_ISA
