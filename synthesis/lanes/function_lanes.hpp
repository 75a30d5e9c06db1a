/// @file The structural errors of many function generators at a time, one in each SIMD lane: the
/// problem of a LaneFit. Include in kernels alone.
///
/// The residual is 2 tan(e/2), e being the error in output angle: e but for its cube, and found
/// from unit vectors without trigonometry. Lengths are unknown by their logarithms: a step d
/// multiplies them by (2 + d)/(2 − d), which is exp(d) but for d³.
#pragma once

#include "analysis/linkage/closure.hpp"
#include "synthesis/lanes/function_fit_kernel.hpp"
#include "synthesis/lanes/lane_directions.hpp"
#include "synthesis/lanes/lane_fit.hpp"
#include "synthesis/lanes/lane_limits.hpp"

namespace cognate::synthesis::COGNATE_ISA {

class FunctionLanes {
 public:
  static constexpr int kMostUnknowns = 10;
  using Equations = NormalEquations<kMostUnknowns>;

  explicit FunctionLanes(const FunctionFitTask& task) : task_(task) {
    while (lengths_ < task.unknowns && task.unknown[lengths_] <= function_frame) ++lengths_;
    // Lanes without a start follow a harmless linkage, whose result is not looked at.
    for (Real& length : here_.length) length = Real(1.0);
    here_.half_input = {Real(0.8), Real(0.6)};
    here_.output = {Real(1.0), Real(0.0)};
    assembly_ = Real(1.0);
  }

  int unknowns() const { return task_.unknowns; }

  bool take(int lane) {
    if (next_start_ >= task_.starts) return false;
    start_of_[lane] = next_start_++;
    const double* state = state_of(lane);
    for (int i = 0; i < 4; ++i) set_lane(here_.length[i], lane, state[i]);
    for (int i = 0; i < lengths_; ++i) {
      const double from = state[task_.unknown[i]], low = task_.lower[i], high = task_.upper[i];
      set_lane(here_.length[task_.unknown[i]], lane, from < low ? low : from > high ? high : from);
    }
    set_lane(here_.half_input, lane, state + 4);
    set_lane(here_.output, lane, state + 6);
    set_lane(assembly_, lane, state[8]);
    return true;
  }

  void give(int lane, double cost, int iterations) {
    double* state = state_of(lane);
    for (int i = 0; i < 4; ++i) state[i] = lane_of(here_.length[i], lane);
    get_lane(here_.half_input, lane, state + 4);
    get_lane(here_.output, lane, state + 6);
    task_.cost[start_of_[lane]] = cost;
    task_.iterations[start_of_[lane]] = iterations;
  }

  Real lowest_step(int i) const {
    return i < lengths_ ? step_to(Real(task_.lower[i]), task_.unknown[i]) : Real(-1.0);
  }
  Real highest_step(int i) const {
    return i < lengths_ ? step_to(Real(task_.upper[i]), task_.unknown[i]) : Real(1.0);
  }

  void linearise(Equations& equations) {
    equations.clear(task_.unknowns);
    const Lengths<Real> links = lengths(here_);
    const HalfClosure<Real> closure(links, +1);
    for (int j = 0; j < task_.targets.samples; ++j) add_sample(j, links, closure, equations);
    for (int i = 0; i < task_.limit_count; ++i) {
      const LinkFunction<Real> at = evaluate(task_.limits[i], here_.length);
      const Real weight = violated(at.value);
      Real row[4];
      for (int k = 0; k < lengths_; ++k) {
        row[k] = weight * at.slope[task_.unknown[k]] * here_.length[task_.unknown[k]];
      }
      equations.add(weight * at.value, row, lengths_);
    }
  }

  Real reduce(const Real&, Equations&) const { return Real(0.0); }

  void attempt(const Real* step, const Real&) {
    next_ = here_;
    for (int i = 0; i < task_.unknowns; ++i) {
      const Real half = Real(0.5) * step[i];
      if (task_.unknown[i] == function_input_start) {
        next_.half_input = turned(here_.half_input, half);
      } else if (task_.unknown[i] == function_output_start) {
        next_.output = turned(turned(here_.output, half), half);
      } else {
        const Real factor = (Real(1.0) + half) / (Real(1.0) - half);
        next_.length[task_.unknown[i]] = here_.length[task_.unknown[i]] * factor;
      }
    }
  }

  Real cost() const {
    const Lengths<Real> links = lengths(next_);
    const HalfClosure<Real> closure(links, +1);
    Real sum(0.0);
    for (int j = 0; j < task_.targets.samples; ++j) {
      const Place at(closure, half_input(j, next_), assembly_);
      const Real residual = doubled_tangent(j, at, next_);
      sum = sum + residual * residual;
      if (!task_.limits_transmission) continue;
      const Real beyond = transmission_weight() * cosine_beyond(at);
      sum = sum + beyond * beyond;
    }
    for (int i = 0; i < task_.limit_count; ++i) {
      const Real value = evaluate(task_.limits[i], next_.length).value;
      const Real missing = violated(value) * value;
      sum = sum + missing * missing;
    }
    return sum;
  }

  void keep(const Mask& lanes) {
    for (int i = 0; i < 4; ++i) {
      here_.length[i] = choose(lanes, next_.length[i], here_.length[i]);
    }
    here_.half_input = choose(lanes, next_.half_input, here_.half_input);
    here_.output = choose(lanes, next_.output, here_.output);
  }

 private:
  struct State {
    Real length[4];
    Direction half_input, output;
  };

  struct Place {
    Direction crank;
    LinkDirections<Real> links;

    Place(const HalfClosure<Real>& closure, const Direction& half, const Real& assembly) {
      const Real versine = (half.y + half.y) * half.y;
      const Real sine = (half.x + half.x) * half.y;
      crank = {Real(1.0) - versine, sine};
      links = closure.at(sine, versine, assembly);
    }
  };

  static Lengths<Real> lengths(const State& state) {
    return {state.length[0], state.length[1], state.length[2], state.length[3]};
  }

  double* state_of(int lane) const {
    return task_.state + static_cast<long>(start_of_[lane]) * kFunctionStateSize;
  }

  /// The step d with length·(2 + d)/(2 − d) = bound.
  Real step_to(const Real& bound, int which) const {
    const Real ratio = bound / here_.length[which];
    return Real(2.0) * (ratio - Real(1.0)) / (ratio + Real(1.0));
  }

  Direction half_input(int j, const State& state) const {
    const Direction increment{Real(task_.targets.half_input_x[j]),
                              Real(task_.targets.half_input_y[j])};
    return increment * state.half_input;
  }

  /// 2 tan(e/2).
  Real doubled_tangent(int j, const Place& at, const State& state) const {
    const Direction wanted =
        state.output * Direction{Real(task_.targets.output_x[j]), Real(task_.targets.output_y[j])};
    const Direction error = conj(wanted) * at.links.rocker;
    return Real(2.0) * error.y / (Real(1.0) + error.x);
  }

  Real violated(const Real& value) const {
    return choose(value < Real(0.0), Real(task_.penalty), Real(0.0));
  }

  Real transmission_weight() const {
    return Real(task_.penalty) / root(Real(double(task_.targets.samples)));
  }

  /// How far the cosine of the transmission angle is beyond its limits, with its sign.
  Real cosine_beyond(const Place& at) const {
    const Real cosine = dot(at.links.coupler, at.links.rocker), zero(0.0);
    return larger(zero, cosine - Real(task_.greatest_cosine)) +
           smaller(zero, cosine - Real(task_.least_cosine));
  }

  void add_sample(int j, const Lengths<Real>& links, const HalfClosure<Real>& closure,
                  Equations& equations) const {
    const Place at(closure, half_input(j, here_), assembly_);
    const Real residual = doubled_tangent(j, at, here_);
    const Real stretch = Real(1.0) + Real(0.25) * residual * residual;
    const auto psi = closure_gradient(links, at.crank, at.links).rocker;
    const Real all[function_unknowns] = {psi.crank * links.crank,   psi.coupler * links.coupler,
                                         psi.rocker * links.rocker, psi.frame * links.frame,
                                         psi.crank_angle,           Real(-1.0)};
    Real row[function_unknowns];
    for (int i = 0; i < task_.unknowns; ++i) row[i] = stretch * all[task_.unknown[i]];
    equations.add(residual, row, task_.unknowns);
    if (task_.limits_transmission) add_transmission(at, links, equations);
  }

  /// cos μ = (l₂² + l₃² − d²)/(2 l₂ l₃) with d² = l₁² + l₄² − 2 l₁ l₄ cos θ.
  void add_transmission(const Place& at, const Lengths<Real>& l, Equations& equations) const {
    const Real beyond = cosine_beyond(at);
    const Real weight = choose(beyond != Real(0.0), transmission_weight(), Real(0.0));
    const Real cosine = dot(at.links.coupler, at.links.rocker);
    const Real inverse = weight / (l.coupler * l.rocker);
    const Real along = l.frame * at.crank.x, square = l.coupler * l.rocker * cosine;
    const Real all[function_unknowns] = {inverse * l.crank * (along - l.crank),
                                         inverse * (l.coupler * l.coupler - square),
                                         inverse * (l.rocker * l.rocker - square),
                                         inverse * l.frame * (l.crank * at.crank.x - l.frame),
                                         -(inverse * l.crank * l.frame * at.crank.y),
                                         Real(0.0)};
    Real row[function_unknowns];
    for (int i = 0; i < task_.unknowns; ++i) row[i] = all[task_.unknown[i]];
    equations.add(weight * beyond, row, task_.unknowns);
  }

  const FunctionFitTask& task_;
  int lengths_ = 0;  ///< how many of the unknowns are lengths
  int next_start_ = 0;
  int start_of_[kLanes] = {};
  State here_, next_;
  Real assembly_;
};

/// The mean squares of the chords 2 sin(e/2) of many linkages, the output start angle being the
/// best for each where it is not given.
inline void screen(const FunctionScreenTask& task, double assembly, double* errors) {
  const double count = task.targets.samples;
  for (long i = 0; i < task.count; i += kLanes) {
    const HalfClosure<Real> closure(Lengths<Real>{load(task.crank + i), load(task.coupler + i),
                                                  load(task.rocker + i), load(task.frame + i)},
                                    +1);
    const Direction start{load(task.half_start_x + i), load(task.half_start_y + i)};
    Direction sum{Real(0.0), Real(0.0)};
    for (int j = 0; j < task.targets.samples; ++j) {
      const Direction half =
          Direction{Real(task.targets.half_input_x[j]), Real(task.targets.half_input_y[j])} * start;
      const Real versine = (half.y + half.y) * half.y, sine = (half.x + half.x) * half.y;
      const Direction wanted{Real(task.targets.output_x[j]), Real(task.targets.output_y[j])};
      sum = sum + conj(wanted) * closure.at(sine, versine, Real(assembly)).rocker;
    }
    Real along = root(squared_norm(sum));
    if (task.output_start_x) {
      along = dot(sum, Direction{load(task.output_start_x + i), load(task.output_start_y + i)});
    }
    store(Real(2.0 / count) * (Real(count) - along), errors + i);
  }
}

}  // namespace cognate::synthesis::COGNATE_ISA
