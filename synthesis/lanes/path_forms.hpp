/// @file The samples of a timed path over boxes of proportions, one box in each lane, and the forms
/// of their coupler's directions. Include in kernels alone.
///
/// Over a box, with τ the turn of a direction u,
///
///     u = u₀(1 + i g·t + [i tᵀQt/2 − (g·t)²/2]) + rest,
///
/// and the forms are those of u₀, the four u₀ i g and the ten coefficients of the bracket.
#pragma once

#include "synthesis/lanes/coupler_models.hpp"
#include "synthesis/lanes/lanes_complex.hpp"
#include "synthesis/lanes/path_proof_kernel.hpp"

namespace cognate::synthesis::COGNATE_ISA {

inline constexpr int kPairs = 10;  // monomials of degree 2 in the four sides

/// One sample over a box, relative to the others.
struct PathSample {
  Real x, y;                     ///< u₀
  Real slope[4], curve[kPairs];  ///< of its angle
  Real cubic[20];
  Real rest;  ///< of the angle, then of u
  Real doubt[4];
  Real weight;  ///< zero where it does not count
};
static_assert(sizeof(PathSample) <= kProofWorkPerSample * sizeof(double));

/// u₀, the four u₀ i g and the ten coefficients of second degree.
inline constexpr int kForms = 15;

/// Sums over the samples with the pivot and the crank eliminated.
struct PathForms {
  Real count;             ///< of samples with weight
  Real weight, residual;  ///< Σ w and Z
  Real rest;              ///< √Σ w rest²
  Real doubt[4];          ///< its parts from samples bounded by their range
  Real rounding;          ///< relative to the magnitudes
  Real squares;           ///< Σ w |z|²
  Mask valid;
  Real size_00, size_0[4], size_pair[4][4], size_0w[kPairs], size_w[kPairs], size_aw[4][kPairs];
  LanesComplex point[kForms];  ///< b
};

/// What the sums of one pass over the samples give besides those of the forms.
struct PathTotals {
  LanesComplex e{Real(0.0), Real(0.0)}, z{Real(0.0), Real(0.0)}, pulled{Real(0.0), Real(0.0)};
  Real rest = Real(0.0), reach = Real(0.0);
};

/// The samples of a path over kLanes boxes.
class PathSamples {
 public:
  explicit PathSamples(const PathProofTask& task)
      : task_(task), sample_(reinterpret_cast<PathSample*>(task.workspace)) {}

  /// The directions of the coupler, without what they have in common.
  void enclose(const LanesBox& box);
  void weigh_by_rest();
  PathForms sums() const;

 private:
  void take_common_out();
  void add_sample(int j, PathForms& forms, LanesComplex* mean, LanesComplex* crank) const;
  void add_totals(int j, PathForms& forms, PathTotals& totals) const;
  static void eliminate(PathForms& forms, const PathTotals& totals, const LanesComplex* mean,
                        LanesComplex* crank, const Real& per_weight, const Real& per_form);

  const PathProofTask& task_;
  PathSample* sample_;
};

inline void PathSamples::enclose(const LanesBox& box) {
  const HalfAngles& phase = box.phase;
  const Real sine = Real(2.0) * phase.sine * phase.cosine;
  const Real cosine = (phase.cosine - phase.sine) * (phase.cosine + phase.sine);
  const CouplerModels models(box, cosine * Real(task_.mean_cosine) - sine * Real(task_.mean_sine));
  for (int j = 0; j < task_.samples; ++j) {
    const CouplerTurn turn = models.at(Real(task_.half_sine[j]), Real(task_.half_cosine[j]));
    PathSample& s = sample_[j];
    s.x = turn.x;
    s.y = turn.y;
    for (int i = 0; i < 4; ++i) s.slope[i] = turn.turn.at[1 + i];
    for (int i = 0; i < kPairs; ++i) s.curve[i] = turn.turn.at[5 + i];
    for (int i = 0; i < 20; ++i) s.cubic[i] = turn.turn.at[15 + i];
    for (int i = 0; i < 4; ++i) s.doubt[i] = turn.doubt[i];
    s.rest = turn.turn.rest;
    s.weight = choose(turn.counted, Real(task_.weight[j]), Real(0.0));
  }
  take_common_out();
}

/// Any polynomial may be taken out of all angles alike: the mean of those known best. Then the
/// samples' rests are those of u.
inline void PathSamples::take_common_out() {
  Real slope[4], curve[kPairs], cubic[20], weight(1e-300);
  const auto clear = [](auto& values) {
    for (Real& value : values) value = Real(0.0);
  };
  clear(slope);
  clear(curve);
  clear(cubic);
  for (int j = 0; j < task_.samples; ++j) {
    const PathSample& s = sample_[j];
    const Real w = choose(s.rest < Real(0.25), s.weight, Real(0.0));
    weight = weight + w;
    for (int i = 0; i < 4; ++i) slope[i] = slope[i] + w * s.slope[i];
    for (int i = 0; i < kPairs; ++i) curve[i] = curve[i] + w * s.curve[i];
    for (int i = 0; i < 20; ++i) cubic[i] = cubic[i] + w * s.cubic[i];
  }
  const Real inverse = Real(1.0) / weight;
  for (int j = 0; j < task_.samples; ++j) {
    PathSample& s = sample_[j];
    Real l(0.0), q(0.0), c(0.0), before(0.0);
    for (int i = 0; i < 4; ++i) {
      before = before + magnitude(s.slope[i]);
      s.slope[i] = s.slope[i] - inverse * slope[i];
      l = l + magnitude(s.slope[i]);
    }
    for (int i = 0; i < kPairs; ++i) {
      before = before + magnitude(s.curve[i]);
      s.curve[i] = s.curve[i] - inverse * curve[i];
      q = q + magnitude(s.curve[i]);
    }
    for (int i = 0; i < 20; ++i) {
      before = before + magnitude(s.cubic[i]);
      c = c + magnitude(s.cubic[i] - inverse * cubic[i]);
    }
    const Real known = s.rest + c + Real(kPad) * (Real(1.0) + before + l + q + c);
    const Real e = q + known, whole = l + e;
    const Real rest = known + l * e + Real(0.5) * e * e + Real(1.0 / 6) * whole * whole * whole;
    s.rest = rest * Real(1 + kPad);
    const Mask counted = s.rest < Real(0.25) && whole < Real(4.0);
    s.weight = choose(counted, s.weight, Real(0.0));
    // Where nothing counts nothing may be infinite either.
    s.rest = choose(counted, s.rest, Real(1.0));
  }
}

/// Less weight to samples of which little is known: any weights up to the true ones bound the
/// error.
inline void PathSamples::weigh_by_rest() {
  Real inverse(0.0), count(0.0);
  for (int j = 0; j < task_.samples; ++j) {
    const Mask counted = sample_[j].weight > Real(0.0);
    inverse = inverse + choose(counted, Real(1.0) / sample_[j].rest, Real(0.0));
    count = count + choose(counted, Real(1.0), Real(0.0));
  }
  const Real fair = Real(3.0) * count / inverse;
  for (int j = 0; j < task_.samples; ++j) {
    const Real ratio = fair / sample_[j].rest;
    sample_[j].weight = choose(
        ratio < Real(1.0), sample_[j].weight * ratio * ratio * Real(1 - kPad), sample_[j].weight);
  }
}

inline void PathSamples::add_sample(int j, PathForms& f, LanesComplex* mean,
                                    LanesComplex* crank) const {
  const PathSample& s = sample_[j];
  const Real w = s.weight;
  const LanesComplex u{w * s.x, w * s.y};
  const LanesComplex e{Real(task_.cosine[j]), Real(task_.sine[j])};
  const LanesComplex z{Real(task_.x[j]), Real(task_.y[j])};
  const LanesComplex from[3] = {u, conjugate_product(e, u), conjugate_product(z, u)};
  LanesComplex* const to[3] = {mean, crank, f.point};
  for (int k = 0; k < 3; ++k) {
    add_to(to[k][0], from[k]);
    for (int a = 0; a < 4; ++a) {
      to[k][1 + a].x = to[k][1 + a].x - s.slope[a] * from[k].y;
      to[k][1 + a].y = to[k][1 + a].y + s.slope[a] * from[k].x;
    }
  }
  for (int a = 0, m = 0; a < 4; ++a) {
    for (int b = a; b < 4; ++b, ++m) {
      // The bracket's coefficient is −p + i c.
      const Real product = s.slope[a] * s.slope[b], c = s.curve[m];
      const Real p = a == b ? Real(0.5) * product : product;
      for (int k = 0; k < 3; ++k) {
        to[k][5 + m].x = to[k][5 + m].x - p * from[k].x - c * from[k].y;
        to[k][5 + m].y = to[k][5 + m].y - p * from[k].y + c * from[k].x;
      }
      const Real wc = w * c, wp = w * p;
      f.size_pair[b][a] = f.size_pair[b][a] + w * product;
      f.size_w[m] = f.size_w[m] + wc * c + wp * p;
      for (int i = 0; i < 4; ++i) f.size_aw[i][m] = f.size_aw[i][m] + wc * s.slope[i];
    }
  }
}

inline void PathSamples::add_totals(int j, PathForms& f, PathTotals& sum) const {
  const Real zero(0.0), one(1.0);
  const PathSample& s = sample_[j];
  const Real w = s.weight;
  const Mask counted = w > zero;
  const LanesComplex e{Real(task_.cosine[j]), Real(task_.sine[j])};
  const LanesComplex z{Real(task_.x[j]), Real(task_.y[j])};
  f.count = f.count + choose(counted, one, zero);
  f.weight = f.weight + w;
  f.squares = f.squares + w * squared(z);
  add_to(sum.e, w * e);
  add_to(sum.z, w * z);
  add_to(sum.pulled, w * conjugate_product(e, z));
  sum.rest = sum.rest + w * s.rest * s.rest;
  Real whole = one;
  for (int i = 0; i < 4; ++i) {
    whole = whole + magnitude(s.slope[i]);
    f.doubt[i] = f.doubt[i] + w * s.doubt[i] * s.doubt[i];
  }
  for (int i = 0; i < kPairs; ++i) whole = whole + magnitude(s.curve[i]);
  sum.reach = larger(sum.reach, choose(counted, whole, zero));
}

inline PathForms PathSamples::sums() const {
  PathForms f;
  LanesComplex mean[kForms], crank[kForms];
  const Real zero(0.0), one(1.0);
  for (int i = 0; i < kForms; ++i) mean[i] = crank[i] = f.point[i] = {zero, zero};
  for (int a = 0; a < 4; ++a) {
    f.doubt[a] = zero;
    for (int b = 0; b < 4; ++b) f.size_pair[a][b] = zero;
    for (int m = 0; m < kPairs; ++m) f.size_aw[a][m] = zero;
  }
  for (int m = 0; m < kPairs; ++m) f.size_w[m] = zero;
  f.count = f.weight = f.squares = zero;
  PathTotals totals;
  for (int j = 0; j < task_.samples; ++j) {
    add_sample(j, f, mean, crank);
    add_totals(j, f, totals);
  }
  const Real per_weight = task_.pivot_fixed ? zero : one / f.weight;
  const Real form = f.weight - per_weight * squared(totals.e);
  const Real per_form = one / form;
  f.valid = f.count >= Real(3.0) && form > Real(1e-9) * f.weight;
  f.rest = root(totals.rest) * Real(1 + kPad);
  const Real magnified = totals.reach * totals.reach * (one + f.weight * per_form);
  f.rounding = Real(4e-15 * (task_.samples + 16)) * magnified;
  eliminate(f, totals, mean, crank, per_weight, per_form);
  return f;
}

/// Eliminates t, the pivot where it is free, and s, the crank.
inline void PathSamples::eliminate(PathForms& f, const PathTotals& totals, const LanesComplex* mean,
                                   LanesComplex* crank, const Real& per_weight,
                                   const Real& per_form) {
  const LanesComplex pulled = totals.pulled - per_weight * conjugate_product(totals.e, totals.z);
  f.residual = f.squares - per_weight * squared(totals.z) - per_form * squared(pulled);
  for (int i = 0; i < kForms; ++i) {
    crank[i] = crank[i] - per_weight * conjugate_product(totals.e, mean[i]);
    f.point[i] = f.point[i] - per_weight * conjugate_product(totals.z, mean[i]) -
                 per_form * conjugate_product(pulled, crank[i]);
  }
  const auto less = [&](const Real& sum, int i, int k) {
    return sum - per_weight * dot(mean[i], mean[k]) - per_form * dot(crank[i], crank[k]);
  };
  f.size_00 = less(f.weight, 0, 0);
  for (int a = 0, m = 0; a < 4; ++a) {
    f.size_0[a] = less(Real(0.0), 0, 1 + a);
    for (int b = a; b < 4; ++b, ++m) {
      f.size_0w[m] = less(Real(a == b ? -0.5 : -1.0) * f.size_pair[b][a], 0, 5 + m);
      f.size_w[m] = larger(Real(0.0), less(f.size_w[m], 5 + m, 5 + m));
      f.size_pair[b][a] = less(f.size_pair[b][a], 1 + a, 1 + b);
    }
    for (int n = 0; n < kPairs; ++n) f.size_aw[a][n] = less(f.size_aw[a][n], 1 + a, 5 + n);
  }
}

}  // namespace cognate::synthesis::COGNATE_ISA
