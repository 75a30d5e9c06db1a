/// @file Levenberg–Marquardt from many starts at a time, one in each SIMD lane. Include in kernels
/// alone.
///
/// A lane whose start has reached its minimum takes the next start at once, so that none waits for
/// the slowest, and what happens in a lane does not depend on the others. Damping by Nielsen 1999,
/// "Damping parameter in Marquardt's method". Unknowns at a bound that the descent would push
/// beyond it stay there; those that the step would take beyond go to their bound, and the others'
/// step is found anew.
#pragma once

#include "synthesis/lanes/lane_numbers.hpp"

namespace cognate::synthesis::COGNATE_ISA {

/// A sum of squares |r|² at a point of each lane, of at most `kMostUnknowns` unknowns.
template <int kMostUnknowns>
struct NormalEquations {
  Real cost;                                   ///< |r|²
  Real gradient[kMostUnknowns];                ///< Jᵀr
  Real hessian[kMostUnknowns][kMostUnknowns];  ///< JᵀJ, each row up to the diagonal

  void clear(int unknowns) {
    cost = Real(0.0);
    for (int i = 0; i < unknowns; ++i) {
      gradient[i] = Real(0.0);
      for (int k = 0; k <= i; ++k) hessian[i][k] = Real(0.0);
    }
  }

  /// Adds a residual that depends on the first `unknowns` unknowns, with its derivatives.
  void add(const Real& residual, const Real* row, int unknowns) {
    cost = cost + residual * residual;
    add_square(Real(1.0), row, residual, unknowns);
  }

  /// Adds weight · row · rowᵀ to JᵀJ and weight · row · residual to Jᵀr.
  void add_square(const Real& weight, const Real* row, const Real& residual, int unknowns) {
    for (int i = 0; i < unknowns; ++i) {
      const Real weighted = weight * row[i];
      gradient[i] = gradient[i] + weighted * residual;
      for (int k = 0; k <= i; ++k) hessian[i][k] = hessian[i][k] + weighted * row[k];
    }
  }
};

/// Minimises ½ dᵀ(H + λD)d + gᵀd over the unknowns that are not held, by LDLᵀ.
template <int kMostUnknowns>
class DampedStep {
 public:
  /// `step`: in, of those that are held; out, of all.
  void solve(const NormalEquations<kMostUnknowns>& at, const Real* damped_diagonal,
             const Mask* held, int n, Real* step) {
    Real rhs[kMostUnknowns];
    for (int i = 0; i < n; ++i) {
      rhs[i] = -at.gradient[i];
      for (int k = 0; k < n; ++k) {
        const Real& h = at.hessian[i < k ? k : i][i < k ? i : k];
        rhs[i] = rhs[i] - h * choose(held[k], step[k], Real(0.0));
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k <= i; ++k) eliminate(at, damped_diagonal, held, i, k);
      step[i] = choose(held[i], step[i], rhs[i]);
      for (int m = 0; m < i; ++m) step[i] = step[i] - factor_[i][m] * step[m];
    }
    for (int i = n - 1; i >= 0; --i) {
      step[i] = step[i] * inverse_pivot_[i];
      for (int m = i + 1; m < n; ++m) step[i] = step[i] - factor_[m][i] * step[m];
    }
  }

 private:
  void eliminate(const NormalEquations<kMostUnknowns>& at, const Real* damped_diagonal,
                 const Mask* held, int i, int k) {
    const Real zero(0.0);
    Real sum = i == k ? choose(held[i], Real(1.0), at.hessian[i][i] + damped_diagonal[i])
                      : choose(held[i] | held[k], zero, at.hessian[i][k]);
    for (int m = 0; m < k; ++m) sum = sum - scaled_[i][m] * factor_[k][m];
    scaled_[i][k] = sum;
    if (i == k) {
      inverse_pivot_[i] = Real(1.0) / sum;
    } else {
      factor_[i][k] = sum * inverse_pivot_[k];
    }
  }

  Real factor_[kMostUnknowns][kMostUnknowns];  ///< L below its diagonal of ones
  Real scaled_[kMostUnknowns][kMostUnknowns];  ///< L·D
  Real inverse_pivot_[kMostUnknowns];
};

/// When a fit ends.
struct FitLimits {
  int most_iterations = 0;
  double tolerance = 0;   ///< relative change of the cost
  double negligible = 0;  ///< costs below count as zero
};

/// `Problem` has
///
///   static constexpr int kMostUnknowns; using Equations = NormalEquations<kMostUnknowns>;
///   int unknowns() const;
///   bool take(int lane);   puts the next start into a lane, if there is one
///   void give(int lane, double cost, int iterations);   takes the result out of it
///   Real lowest_step(int i) const, highest_step(int i) const;   of unknown i, to its bounds
///   void linearise(Equations&);   at the point where the lanes are
///   Real reduce(const Real& damping, Equations&);   eliminates unknowns of single residuals,
///                                                  if there are any; what their step alone gains
///   void attempt(Real* step, const Real& damping);   looks `step` ahead
///   Real cost();   of the attempt, not a number where it has none
///   void keep(const Mask& lanes);   goes there;
///   bool is_hopeless(double cost, int iterations) const;   optional: gives a start up.
template <class Problem>
class LaneFit {
 public:
  LaneFit(Problem& problem, const FitLimits& limits) : problem_(problem), limits_(limits) {}

  void run() {
    for (int lane = 0; lane < kLanes; ++lane) refill(lane);
    while (active_ > 0) iterate();
  }

 private:
  struct Lane {
    bool busy = false, finished = false;
    int iterations = 0, stalled = 0;
    double growth = 2, cost = 0;
  };

  void refill(int lane) {
    lanes_[lane] = Lane();
    damping_[lane] = 1e-3;
    for (int i = 0; i < problem_.unknowns(); ++i) set_lane(diagonal_[i], lane, 0.0);
    lanes_[lane].busy = problem_.take(lane);
    active_ += lanes_[lane].busy;
  }

  void iterate() {
    problem_.linearise(now_);
    double before[kLanes], after[kLanes], gain[kLanes], kept[kLanes];
    store(now_.cost, before);
    const Real damping = load(damping_);
    const int n = problem_.unknowns();
    for (int i = 0; i < n; ++i) diagonal_[i] = larger(diagonal_[i], now_.hessian[i][i]);
    const Real local_gain = problem_.reduce(damping, now_);
    find_step(damping);
    problem_.attempt(step_, damping);
    store(local_gain + predicted_gain(), gain);
    store(problem_.cost(), after);
    for (int lane = 0; lane < kLanes; ++lane) {
      kept[lane] = judge(lane, before[lane], after[lane], gain[lane]) ? 1 : 0;
    }
    problem_.keep(load(kept) > Real(0.5));
    for (int lane = 0; lane < kLanes; ++lane) {
      if (!lanes_[lane].busy || !lanes_[lane].finished) continue;
      problem_.give(lane, lanes_[lane].cost, lanes_[lane].iterations);
      --active_;
      refill(lane);
    }
  }

  void find_step(const Real& damping) {
    const int n = problem_.unknowns();
    Real largest(0.0);
    for (int i = 0; i < n; ++i) largest = larger(largest, diagonal_[i]);
    const Real floor = Real(1e-14) * largest + Real(1e-300);
    Real damped[Problem::kMostUnknowns];
    Mask held[Problem::kMostUnknowns];
    const Real zero(0.0);
    for (int i = 0; i < n; ++i) {
      damped[i] = damping * diagonal_[i] + floor;
      const Real& slope = now_.gradient[i];
      held[i] = ((problem_.lowest_step(i) >= zero) & (slope > zero)) |
                ((problem_.highest_step(i) <= zero) & (slope < zero));
      step_[i] = zero;
    }
    solver_.solve(now_, damped, held, n, step_);
    bool beyond = false;
    for (int i = 0; i < n; ++i) {
      const Real within =
          larger(problem_.lowest_step(i), smaller(problem_.highest_step(i), step_[i]));
      const Mask clamped = within != step_[i];
      held[i] = held[i] | clamped;
      step_[i] = within;
      beyond = beyond || any(clamped);
    }
    if (!beyond) return;
    solver_.solve(now_, damped, held, n, step_);
    for (int i = 0; i < n; ++i) {
      step_[i] = larger(problem_.lowest_step(i), smaller(problem_.highest_step(i), step_[i]));
    }
  }

  /// −2 g·d − dᵀHd.
  Real predicted_gain() const {
    Real gain(0.0);
    for (int i = 0; i < problem_.unknowns(); ++i) {
      Real slope = now_.gradient[i] + now_.gradient[i] + now_.hessian[i][i] * step_[i];
      for (int k = 0; k < i; ++k) {
        slope = slope + (now_.hessian[i][k] + now_.hessian[i][k]) * step_[k];
      }
      gain = gain - slope * step_[i];
    }
    return gain;
  }

  /// Whether a lane goes on to what it attempted; sets its damping and whether it has finished.
  bool judge(int index, double before, double after, double predicted) {
    Lane& lane = lanes_[index];
    if (!lane.busy) return false;
    lane.cost = before;
    ++lane.iterations;
    lane.finished = lane.iterations >= limits_.most_iterations || !std::isfinite(before);
    if constexpr (requires { problem_.is_hopeless(before, lane.iterations); }) {
      lane.finished |= problem_.is_hopeless(before, lane.iterations);
    }
    const double gained = before - after;
    double& damping = damping_[index];
    if (gained > 1e-4 * predicted && gained > 0) {
      const double excess = 2 * gained / predicted - 1;
      const double factor = 1 - excess * excess * excess;
      damping *= factor < 1.0 / 3 ? 1.0 / 3 : factor > 2 ? 2 : factor;
      if (damping < 1e-15) damping = 1e-15;
      lane.growth = 2;
      lane.cost = after;
      lane.stalled = gained <= limits_.tolerance * before ? lane.stalled + 1 : 0;
      lane.finished |= lane.stalled >= 2 || after <= limits_.negligible;
      return true;
    }
    // A step that was cut off at bounds may promise nothing: then a shorter one does.
    const bool negligible =
        predicted >= 0 && predicted <= limits_.tolerance * before + limits_.negligible;
    lane.finished |= negligible || damping > 1e12;
    damping *= lane.growth;
    lane.growth *= 2;
    return false;
  }

  Problem& problem_;
  FitLimits limits_;
  static constexpr int kMostUnknowns = Problem::kMostUnknowns;

  NormalEquations<kMostUnknowns> now_;
  DampedStep<kMostUnknowns> solver_;
  Real diagonal_[kMostUnknowns], step_[kMostUnknowns];
  Lane lanes_[kLanes];
  double damping_[kLanes] = {};
  int active_ = 0;
};

}  // namespace cognate::synthesis::COGNATE_ISA
