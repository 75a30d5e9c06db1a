/// @file The distances of a path from its targets for many linkages at a time, one in each SIMD
/// lane: the problem of a LaneFit. Include in kernels alone.
///
/// Residuals and derivatives are taken in the axes of the frame, where the linkage moves: that
/// changes neither |r|² nor JᵀJ. The crank angle of a point that is not timed touches its own
/// two residuals alone and is eliminated there. Directions are unit vectors; a step d turns them by
/// 2 arctan(d/2), which is d but for its cube, without trigonometry.
#pragma once

#include "analysis/linkage/closure.hpp"
#include "synthesis/lanes/lane_directions.hpp"
#include "synthesis/lanes/lane_fit.hpp"
#include "synthesis/lanes/lane_limits.hpp"
#include "synthesis/lanes/path_fit_kernel.hpp"

namespace cognate::synthesis::COGNATE_ISA {

class PathLanes {
 public:
  static constexpr int kMostUnknowns = 10;
  using Equations = NormalEquations<kMostUnknowns>;

  explicit PathLanes(const PathFitTask& task) : task_(task) {
    double* next = task.workspace;
    const auto reserve = [&](int per_point) {
      double* begin = next;
      next += static_cast<long>(per_point) * task.points * kLanes;
      return begin;
    };
    half_ = reserve(2);
    next_half_ = reserve(2);
    local_row_ = reserve(path_unknowns);
    local_square_ = reserve(1);
    local_rhs_ = reserve(1);
    while (lengths_ < task.unknowns && task.unknown[lengths_] <= path_frame) ++lengths_;
    idle();
  }

  int unknowns() const { return task_.unknowns; }

  bool take(int lane) {
    if (next_start_ >= task_.starts) return false;
    const int start = next_start_++;
    start_of_[lane] = start;
    const double* state = task_.state + static_cast<long>(start) * kPathStateSize;
    for (int i = 0; i < 8; ++i) set_lane(here_.value[i], lane, state[i]);
    for (int i = 0; i < task_.unknowns && task_.unknown[i] <= path_anchor_y; ++i) {
      const double from = state[task_.unknown[i]], low = task_.lower[i], high = task_.upper[i];
      set_lane(here_.value[task_.unknown[i]], lane, from < low ? low : from > high ? high : from);
    }
    set_lane(here_.frame, lane, state + 8);
    set_lane(here_.half_phase, lane, state + 10);
    set_lane(assembly_, lane, state[12]);
    const double* half = task_.crank_half + static_cast<long>(start) * 2 * task_.points;
    for (int i = 0; i < 2 * task_.points; ++i) {
      half_[i * kLanes + lane] = next_half_[i * kLanes + lane] = half[i];
    }
    return true;
  }

  void give(int lane, double cost, int iterations) {
    const int start = start_of_[lane];
    double* state = task_.state + static_cast<long>(start) * kPathStateSize;
    for (int i = 0; i < 8; ++i) state[i] = lane_of(here_.value[i], lane);
    get_lane(here_.frame, lane, state + 8);
    get_lane(here_.half_phase, lane, state + 10);
    double* half = task_.crank_half + static_cast<long>(start) * 2 * task_.points;
    for (int i = 0; i < 2 * task_.points; ++i) half[i] = half_[i * kLanes + lane];
    task_.cost[start] = cost;
    task_.iterations[start] = iterations;
  }

  Real lowest_step(int i) const { return step_to(i, task_.lower[i], -kNoBound); }
  Real highest_step(int i) const { return step_to(i, task_.upper[i], kNoBound); }

  void linearise(Equations& equations) {
    equations.clear(task_.unknowns);
    const Linkage linkage(task_, here_);
    for (int j = 0; j < task_.points; ++j) {
      Real residual[kRows], row[kRows][path_unknowns], local[kRows];
      const Place at(linkage, crank_half(j, here_, half_), assembly_);
      const Vec2<Real> error = differentiate(linkage, at, j, row, local);
      residual[0] = error.x;
      residual[1] = error.y;
      const int rows = task_.limits_transmission ? kRows : 2;
      if (rows > 2) residual[2] = limit_transmission(linkage, at, j, row[2], local[2]);
      for (int k = 0; k < rows; ++k) equations.add(residual[k], row[k], task_.unknowns);
      if (!task_.is_timed[j]) store_local(j, rows, residual, row, local);
    }
    for (int i = 0; i < task_.limit_count; ++i) add_limit(task_.limits[i], equations);
    if (task_.boxed) add_box(equations);
  }

  /// What is left of the equations when each crank angle takes its best, damped step.
  Real reduce(const Real& damping, Equations& equations) const {
    Real gain(0.0);
    if (!task_.any_free) return gain;
    const Real more = Real(1.0) + damping;
    for (int j = 0; j < task_.points; ++j) {
      if (task_.is_timed[j]) continue;
      const Real inverse = Real(1.0) / (load(local_square_ + j * kLanes) * more + Real(1e-300));
      const Real rhs = load(local_rhs_ + j * kLanes);
      Real row[path_unknowns];
      for (int i = 0; i < task_.unknowns; ++i) row[i] = load_row(j, i);
      equations.add_square(-inverse, row, rhs, task_.unknowns);
      gain = gain + inverse * rhs * rhs;
    }
    return gain;
  }

  void attempt(const Real* step, const Real& damping) {
    next_ = here_;
    Real turn(0.0), phase(0.0);
    for (int i = 0; i < task_.unknowns; ++i) {
      const int which = task_.unknown[i];
      if (which == path_frame_angle) {
        turn = step[i];
      } else if (which == path_phase) {
        phase = step[i];
      } else {
        next_.value[which] = larger(Real(task_.lower[i]),
                                    smaller(Real(task_.upper[i]), here_.value[which] + step[i]));
      }
    }
    const Real half(0.5);
    next_.frame = turned(turned(here_.frame, half * turn), half * turn);
    if (task_.counted_from_x) phase = phase - turn;
    next_.half_phase = turned(here_.half_phase, half * phase);
    if (task_.any_free) attempt_locals(step, damping);
  }

  Real cost() const {
    const Linkage linkage(task_, next_);
    Real sum(0.0);
    for (int j = 0; j < task_.points; ++j) {
      const Place at(linkage, crank_half(j, next_, next_half_), assembly_);
      sum = sum + squared_norm(Real(task_.root_weight[j]) * (linkage.to_target(j) + at.arm));
      if (task_.limits_transmission) {
        const Real miss = Real(task_.penalty) * beyond(at.transmission_cosine());
        sum = sum + miss * miss;
      }
    }
    for (int i = 0; i < task_.limit_count; ++i) {
      sum = sum + squared_penalty(evaluate(task_.limits[i], next_.value).value);
    }
    if (task_.boxed) {
      const Direction pivot = other_pivot(next_);
      for (int side = 0; side < 4; ++side) sum = sum + squared_penalty(within(side, pivot));
    }
    return sum;
  }

  void keep(const Mask& lanes) {
    for (int i = 0; i < 8; ++i) here_.value[i] = choose(lanes, next_.value[i], here_.value[i]);
    here_.frame = choose(lanes, next_.frame, here_.frame);
    here_.half_phase = choose(lanes, next_.half_phase, here_.half_phase);
    if (!task_.any_free) return;
    for (int i = 0; i < 2 * task_.points; ++i) {
      double* at = half_ + i * kLanes;
      store(choose(lanes, load(next_half_ + i * kLanes), load(at)), at);
    }
  }

 private:
  struct State {
    Real value[8];  ///< of the unknowns that are no angles; the first four are the lengths
    Direction frame, half_phase;
  };

  static constexpr double kNoBound = 1e3;
  /// Residuals of a point: its distance in two axes, and how far its transmission angle is beyond
  /// the limits.
  static constexpr int kRows = 3;

  /// Angles have no bounds here: what the file says of them is left to whoever takes the fit on.
  Real step_to(int i, double bound, double of_angles) const {
    const int which = task_.unknown[i];
    return which <= path_anchor_y ? Real(bound) - here_.value[which] : Real(of_angles);
  }

  /// What of a state is the same for all points.
  struct Linkage {
    const PathFitTask& task;
    Lengths<Real> links;
    HalfClosure<Real> closure;
    Direction point, to_a, axes;
    Vec2<Real> anchor;

    Linkage(const PathFitTask& all, const State& state)
        : task(all),
          links{state.value[path_crank], state.value[path_coupler], state.value[path_rocker],
                state.value[path_frame]},
          closure(links, +1),
          point{state.value[path_point_u], state.value[path_point_v]},
          to_a{all.anchored_at_d ? -links.frame : Real(0.0), Real(0.0)},
          axes(conj(state.frame)),
          anchor{state.value[path_anchor_x], state.value[path_anchor_y]} {}

    /// From the target to A, in the frame's axes.
    Vec2<Real> to_target(int j) const {
      const Vec2<Real> target{Real(task.target_x[j]), Real(task.target_y[j])};
      return axes * (anchor - target) + to_a;
    }
  };

  /// A linkage at one crank angle. One form of the closure serves the whole circle: the last digits
  /// near change points are left to whoever takes the minimum on.
  struct Place {
    Direction crank;
    LinkDirections<Real> links;
    Vec2<Real> swing;  ///< from B to the coupler point
    Vec2<Real> arm;    ///< from A to the coupler point

    Place(const Linkage& linkage, const Direction& half, const Real& assembly) {
      const Real versine = (half.y + half.y) * half.y;
      const Real sine = (half.x + half.x) * half.y;
      crank = {Real(1.0) - versine, sine};
      links = linkage.closure.at(sine, versine, assembly);
      swing = links.coupler * linkage.point;
      arm = linkage.links.crank * crank + swing;
    }

    /// Of the angle between coupler and rocker.
    Real transmission_cosine() const {
      return links.coupler.x * links.rocker.x + links.coupler.y * links.rocker.y;
    }
  };

  Direction crank_half(int j, const State& state, const double* halves) const {
    const Direction half{load(halves + 2 * j * kLanes), load(halves + (2 * j + 1) * kLanes)};
    return task_.is_timed[j] ? half * state.half_phase : half;
  }

  Vec2<Real> differentiate(const Linkage& linkage, const Place& at, int j,
                           Real (&row)[kRows][path_unknowns], Real (&local)[kRows]) const {
    const auto phi = closure_gradient(linkage.links, at.crank, at.links).coupler;
    const Vec2<Real> by_phi = perp(at.swing);
    const Vec2<Real> by_theta = linkage.links.crank * perp(at.crank) + phi.crank_angle * by_phi;
    const Real weight(task_.root_weight[j]), zero(0.0);
    const Vec2<Real> whole = linkage.to_a + at.arm;
    const Vec2<Real> with_frame{Real(task_.anchored_at_d ? -1.0 : 0.0), zero};
    const bool is_timed = task_.is_timed[j];
    const bool against = is_timed && task_.counted_from_x;
    const Vec2<Real> by_turn = against ? perp(whole) - by_theta : perp(whole);
    const Vec2<Real> by_phase = is_timed ? by_theta : Vec2<Real>{zero, zero};
    const Vec2<Real> all[path_unknowns] = {at.crank + phi.crank * by_phi,
                                           phi.coupler * by_phi,
                                           phi.rocker * by_phi,
                                           with_frame + phi.frame * by_phi,
                                           at.links.coupler,
                                           perp(at.links.coupler),
                                           linkage.axes,
                                           perp(linkage.axes),
                                           by_turn,
                                           by_phase};
    for (int i = 0; i < task_.unknowns; ++i) {
      const Vec2<Real>& derivative = all[task_.unknown[i]];
      row[0][i] = weight * derivative.x;
      row[1][i] = weight * derivative.y;
    }
    local[0] = weight * by_theta.x;
    local[1] = weight * by_theta.y;
    return weight * (linkage.to_target(j) + at.arm);
  }

  /// How far cos μ is above its greatest value, or, negative, below its least.
  Real beyond(const Real& cosine) const {
    const Real zero(0.0);
    return larger(cosine - Real(task_.greatest_cosine), zero) +
           smaller(cosine - Real(task_.least_cosine), zero);
  }

  /// The penalty of a transmission angle beyond its limits, as a residual with its derivatives:
  /// 2 l₂ l₃ cos μ = l₂² + l₃² − l₁² − l₄² + 2 l₁ l₄ cos θ.
  Real limit_transmission(const Linkage& linkage, const Place& at, int j,
                          Real (&row)[path_unknowns], Real& local) const {
    const auto& [crank, coupler, rocker, frame] = linkage.links;
    const Real cosine = at.transmission_cosine(), zero(0.0);
    const Real miss = beyond(cosine);
    const Real weight = choose(miss == zero, zero, Real(task_.penalty));
    const Real scale = weight / (coupler * rocker);
    const bool is_timed = task_.is_timed[j], against = is_timed && task_.counted_from_x;
    Real all[path_unknowns];
    for (Real& slope : all) slope = zero;
    local = -(scale * crank * frame * at.crank.y);
    all[path_crank] = scale * (frame * at.crank.x - crank);
    all[path_coupler] = scale * (coupler - cosine * rocker);
    all[path_rocker] = scale * (rocker - cosine * coupler);
    all[path_frame] = scale * (crank * at.crank.x - frame);
    if (against) all[path_frame_angle] = -local;
    if (is_timed) all[path_phase] = local;
    for (int i = 0; i < task_.unknowns; ++i) row[i] = all[task_.unknown[i]];
    return Real(task_.penalty) * miss;
  }

  void store_local(int j, int rows, const Real (&residual)[kRows],
                   const Real (&row)[kRows][path_unknowns], const Real (&local)[kRows]) {
    Real square(0.0), rhs(0.0);
    for (int k = 0; k < rows; ++k) {
      square = square + local[k] * local[k];
      rhs = rhs + local[k] * residual[k];
    }
    store(square, local_square_ + j * kLanes);
    store(rhs, local_rhs_ + j * kLanes);
    for (int i = 0; i < task_.unknowns; ++i) {
      Real along(0.0);
      for (int k = 0; k < rows; ++k) along = along + local[k] * row[k][i];
      store(along, local_row_ + (j * path_unknowns + i) * kLanes);
    }
  }

  Real load_row(int j, int i) const { return load(local_row_ + (j * path_unknowns + i) * kLanes); }

  /// The crank angles follow the step of the other unknowns, by at most a third of a radian.
  void attempt_locals(const Real* step, const Real& damping) {
    const Real more = Real(1.0) + damping, most(1.0 / 3), half(0.5);
    for (int j = 0; j < task_.points; ++j) {
      if (task_.is_timed[j]) continue;
      Real along = load(local_rhs_ + j * kLanes);
      for (int i = 0; i < task_.unknowns; ++i) along = along + load_row(j, i) * step[i];
      const Real free = -along / (load(local_square_ + j * kLanes) * more + Real(1e-300));
      const Real change = larger(-most, smaller(most, free));
      const Direction next = turned(crank_half(j, here_, half_), half * change);
      store(next.x, next_half_ + 2 * j * kLanes);
      store(next.y, next_half_ + (2 * j + 1) * kLanes);
    }
  }

  Real squared_penalty(const Real& value) const {
    const Real missing = Real(task_.penalty) * smaller(value, Real(0.0));
    return missing * missing;
  }

  void add_limit(const LinkLimit& limit, Equations& equations) const {
    const LinkFunction<Real> at = evaluate(limit, here_.value);
    const Real weight = choose(at.value < Real(0.0), Real(task_.penalty), Real(0.0));
    Real row[4];
    for (int i = 0; i < lengths_; ++i) row[i] = weight * at.slope[task_.unknown[i]];
    equations.add(weight * at.value, row, lengths_);
  }

  Vec2<Real> other_pivot(const State& state) const {
    const Real away = task_.anchored_at_d ? -state.value[path_frame] : state.value[path_frame];
    return {state.value[path_anchor_x] + away * state.frame.x,
            state.value[path_anchor_y] + away * state.frame.y};
  }

  /// How far the pivot is inside of one side of its box.
  Real within(int side, const Vec2<Real>& pivot) const {
    const Real& at = side < 2 ? pivot.x : pivot.y;
    return side % 2 == 0 ? at - Real(task_.box[side]) : Real(task_.box[side]) - at;
  }

  void add_box(Equations& equations) const {
    const Vec2<Real> pivot = other_pivot(here_);
    const Real zero(0.0);
    const Vec2<Real> along =
        task_.anchored_at_d ? Vec2<Real>{-here_.frame.x, -here_.frame.y} : here_.frame;
    const Vec2<Real> across = here_.value[path_frame] * perp(along);
    for (int side = 0; side < 4; ++side) {
      const Real value = within(side, pivot);
      const bool is_x = side < 2;
      const Real weight =
          choose(value < zero, Real(side % 2 == 0 ? task_.penalty : -task_.penalty), zero);
      const Real missing = choose(value < zero, Real(task_.penalty) * value, zero);
      Real all[path_unknowns], row[path_unknowns];
      for (Real& entry : all) entry = zero;
      all[path_frame] = weight * (is_x ? along.x : along.y);
      all[path_frame_angle] = weight * (is_x ? across.x : across.y);
      all[is_x ? path_anchor_x : path_anchor_y] = weight;
      for (int i = 0; i < task_.unknowns; ++i) row[i] = all[task_.unknown[i]];
      equations.add(missing, row, task_.unknowns);
    }
  }

  /// Lanes without a start follow a harmless linkage, whose result is not looked at.
  void idle() {
    for (Real& value : here_.value) value = Real(1.0);
    here_.frame = here_.half_phase = {Real(1.0), Real(0.0)};
    assembly_ = Real(1.0);
    for (int i = 0; i < 2 * task_.points; ++i) {
      store(Real(0.6), half_ + i * kLanes);
      store(Real(0.6), next_half_ + i * kLanes);
    }
  }

  const PathFitTask& task_;
  int lengths_ = 0;  ///< how many of the unknowns are lengths
  int next_start_ = 0;
  int start_of_[kLanes] = {};
  State here_, next_;
  Real assembly_;
  // For each point: half directions of the crank, here and attempted, and what its crank angle
  // contributes to the equations.
  double *half_, *next_half_, *local_row_, *local_square_, *local_rhs_;
};

}  // namespace cognate::synthesis::COGNATE_ISA
