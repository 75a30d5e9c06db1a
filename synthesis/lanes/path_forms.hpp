/// @file Whether the error of a timed path surely exceeds a target over boxes of proportions, one
/// in each lane. Include in kernels alone.
///
/// As in path_bound.hpp the error is at least F where H(u) = κ(U(u) + λ) − |b(u)|² ≥ 0, a form in
/// the directions u of the coupler. Over a box, with τ the turn of a direction,
///
///     u = u₀(1 + i g·t + [i tᵀQt/2 − (g·t)²/2]) + rest,
///
/// and H is taken apart by degree: up to the second exactly, the third by its coefficients, the
/// fourth and the rest by norms.
#pragma once

#include "synthesis/lanes/coupler_models.hpp"
#include "synthesis/lanes/least_over_lanes.hpp"
#include "synthesis/lanes/path_proof_kernel.hpp"

namespace cognate::synthesis::COGNATE_ISA {

inline constexpr int kPathSweeps = 24;
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

/// The place of the monomial t_i t_j.
constexpr int pair_of(int i, int j) {
  return i <= j ? i * 4 - i * (i - 1) / 2 + (j - i) : pair_of(j, i);
}

/// What the sums of one pass over the samples give besides those of the forms.
struct PathTotals {
  LanesComplex e{Real(0.0), Real(0.0)}, z{Real(0.0), Real(0.0)}, pulled{Real(0.0), Real(0.0)};
  Real rest{0.0}, reach{0.0};
};

/// What is left of H's least value over the box, κ and Σ ‖∇H‖, where q's limit has the multiplier
/// `on_point`.
struct PathExcess {
  Real least, kappa, gradients;
};

class PathProof {
 public:
  explicit PathProof(const PathProofTask& task)
      : task_(task), sample_(reinterpret_cast<PathSample*>(task.workspace)) {}

  /// Judges the boxes [first, first + kLanes).
  void judge(int first);

 private:
  LanesBox load_box(int first) const;
  void enclose(const LanesBox& box);
  void take_common_out();
  void weigh_by_rest();
  PathForms sums() const;
  void add_sample(int j, PathForms& forms, LanesComplex* mean, LanesComplex* crank) const;
  void add_totals(int j, PathForms& forms, PathTotals& totals) const;
  void eliminate(PathForms& forms, const PathTotals& totals, const LanesComplex* mean,
                 LanesComplex* crank, const Real& per_weight, const Real& per_form) const;
  PathExcess excess(const PathForms& forms, double target) const;
  PathExcess excess_with(const PathForms& forms, double target, const Real& on_point) const;
  Real best_side(const LanesBox& box, const PathForms& forms, const PathExcess& excess) const;

  const PathProofTask& task_;
  PathSample* sample_;
};

inline LanesBox PathProof::load_box(int first) const {
  const auto number = [&](int which) { return load(task_.box + which * kProofBoxes + first); };
  const auto angle = [&](int which) {
    const int at = proof_angles + 5 * which;
    return HalfAngles{number(at), number(at + 1), number(at + 2), number(at + 3), number(at + 4)};
  };
  return {number(proof_k),
          number(proof_half_k),
          number(proof_side),
          number(proof_assembly),
          angle(0),
          angle(1),
          angle(2)};
}

inline void PathProof::enclose(const LanesBox& box) {
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
}

/// Any polynomial may be taken out of all angles alike: the mean of those known best. Then the
/// samples' rests are those of u.
inline void PathProof::take_common_out() {
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
inline void PathProof::weigh_by_rest() {
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

/// conj(a) b
inline LanesComplex conjugate_product(const LanesComplex& a, const LanesComplex& b) {
  return {a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x};
}
inline Real dot(const LanesComplex& a, const LanesComplex& b) {
  return a.x * b.x + a.y * b.y;
}
inline Real squared(const LanesComplex& a) {
  return a.x * a.x + a.y * a.y;
}
inline void add_to(LanesComplex& sum, const LanesComplex& part) {
  sum.x = sum.x + part.x;
  sum.y = sum.y + part.y;
}
/// (re + i im) a
inline LanesComplex turned(const Real& re, const Real& im, const LanesComplex& a) {
  return {re * a.x - im * a.y, re * a.y + im * a.x};
}

inline void PathProof::add_sample(int j, PathForms& f, LanesComplex* mean,
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

inline void PathProof::add_totals(int j, PathForms& f, PathTotals& sum) const {
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

inline PathForms PathProof::sums() const {
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
inline void PathProof::eliminate(PathForms& f, const PathTotals& totals, const LanesComplex* mean,
                                 LanesComplex* crank, const Real& per_weight,
                                 const Real& per_form) const {
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

/// The sum of the absolute coefficients of H's terms of third degree.
inline Real third_degree(const PathForms& f, const Real& kappa) {
  using All = Monomials<kAllSides>;
  Real cubic[20];
  for (Real& sum : cubic) sum = Real(0.0);
  unrolled<4>([&](auto side) {
    unrolled<kPairs>([&](auto pair) {
      constexpr int a = decltype(side)::value, m = decltype(pair)::value;
      constexpr int to =
          All::place(All::kPowers[1 + a] + All::kPowers[All::kQuadratic + m]) - All::kCubic;
      cubic[to] = cubic[to] + kappa * f.size_aw[a][m] - dot(f.point[1 + a], f.point[5 + m]);
    });
  });
  Real sum(0.0);
  for (const Real& coefficient : cubic) sum = sum + magnitude(coefficient);
  return Real(2.0) * sum;
}

inline PathExcess PathProof::excess_with(const PathForms& f, double target,
                                         const Real& on_point) const {
  const double far = task_.farthest_point;
  const Real far_square(std::isfinite(far) ? far * far : 0.0), zero(0.0);
  PathExcess result;
  const Real kappa = f.residual - on_point * far_square - Real(target) -
                     f.rounding * (f.squares + on_point * far_square);
  result.kappa = kappa;
  const Real unsure = f.rounding * (kappa * (f.weight + on_point) + f.weight * f.squares);
  const Real unsure_gradient =
      f.rounding * f.weight * (kappa * kappa + (f.residual + Real(2.0) * kappa) * f.squares);
  const auto gradient = [&](const Real& size, const Real& squared_point) {
    const Real square = kappa * kappa * size + (f.residual - Real(2.0) * kappa) * squared_point;
    return root(larger(zero, square) + unsure_gradient);
  };
  LanesQuadratic h;
  h.constant = kappa * (f.size_00 + on_point) - squared(f.point[0]);
  result.gradients = gradient(f.size_00, squared(f.point[0]));
  Real fourth(0.0);
  for (int a = 0, m = 0; a < 4; ++a) {
    h.slope[a] = kappa * f.size_0[a] - dot(f.point[0], f.point[1 + a]);
    result.gradients = result.gradients + gradient(f.size_pair[a][a], squared(f.point[1 + a]));
    for (int b = a; b < 4; ++b, ++m) {
      const Real curved = kappa * f.size_0w[m] - dot(f.point[0], f.point[5 + m]);
      h.a[b][a] = kappa * f.size_pair[b][a] - dot(f.point[1 + a], f.point[1 + b]) +
                  (a == b ? Real(2.0) * curved : curved);
      result.gradients = result.gradients + gradient(f.size_w[m], squared(f.point[5 + m]));
      fourth = fourth + about_size(f.point[5 + m]);
    }
  }
  const Real lost = third_degree(f, kappa) + fourth * fourth +
                    f.rest * (Real(2.0) * result.gradients + f.residual * f.rest) + unsure;
  const Real wanted = lost * Real(1 + 1e-12);
  const Real least = least_over_box(h, wanted, kPathSweeps) - wanted;
  result.least = choose(f.valid && kappa > zero, least, Real(-1e300));
  return result;
}

inline PathExcess PathProof::excess(const PathForms& f, double target) const {
  const double far = task_.farthest_point;
  const Real zero(0.0);
  const Real start = larger(zero, root(squared(f.point[0])) * Real(1 / far) - f.size_00);
  PathExcess result = excess_with(f, target, start);
  if (!std::isfinite(far)) return result;
  // Where u is nearly t + s·e, H is too small for its rounding and rest. What q's multiplier adds
  // to it counts more there than what it takes from Z.
  const Real added = Real(-2.0) * result.least / result.kappa;
  const Mask again = result.least < zero && result.kappa > zero &&
                     added * Real(far * far) < Real(0.3) * result.kappa;
  if (!any(again)) return result;
  const PathExcess second = excess_with(f, target, choose(again, start + added, start));
  result.least = larger(result.least, choose(again, second.least, Real(-1e300)));
  return result;
}

/// The side whose halving promises most: by what it has in the terms that are bounded by norms, or,
/// where little is known, the widest.
inline Real PathProof::best_side(const LanesBox& box, const PathForms& f,
                                 const PathExcess& excess) const {
  const Real zero(0.0);
  const auto norm = [&](const Real& square) { return root(larger(zero, square)); };
  Real of_side[4], of_pairs[4], all(0.0), pairs(0.0);
  for (int i = 0; i < 4; ++i) {
    of_side[i] = norm(f.size_pair[i][i]);
    all = all + of_side[i];
    of_pairs[i] = zero;
  }
  for (int a = 0, m = 0; a < 4; ++a) {
    for (int b = a; b < 4; ++b, ++m) {
      const Real size = norm(f.size_w[m]);
      pairs = pairs + size;
      of_pairs[a] = of_pairs[a] + Real(0.5) * size;
      of_pairs[b] = of_pairs[b] + Real(0.5) * size;
    }
  }
  const Mask known = f.valid && excess.kappa > zero && f.count >= Real(0.5 * task_.samples);
  const Real per_rest = Real(2.0) * excess.gradients / excess.kappa;
  const Real half[4] = {Real(2.0) * box.half_k / smaller(box.k, Real(1.0) - box.k), box.first.half,
                        box.second.half, box.phase.half};
  Real side(-1.0), most(0.0);
  for (int i = 0; i < 4; ++i) {
    const Real loss =
        of_side[i] * (pairs + f.rest) + all * of_pairs[i] + per_rest * norm(f.doubt[i]);
    const Real score = choose(known, loss, half[i]);
    const Mask better = score > most;
    side = choose(better, Real(double(i)), side);
    most = choose(better, score, most);
  }
  return side;
}

inline void PathProof::judge(int first) {
  const LanesBox box = load_box(first);
  enclose(box);
  take_common_out();
  const Real zero(0.0), one(1.0), two(2.0);
  PathForms forms = sums();
  PathExcess found = excess(forms, task_.target);
  Real reached = choose(found.least >= zero, two, zero), side = zero;
  if (any(reached < two)) {
    side = best_side(box, forms, found);
    weigh_by_rest();
    forms = sums();
    found = excess(forms, task_.target);
    reached = choose(found.least >= zero, two, reached);
    if (task_.first_target < task_.target && any(reached < two)) {
      found = excess(forms, task_.first_target);
      reached = choose(found.least >= zero && reached < two, one, reached);
    }
  }
  double values[2][kLanes];
  store(reached, values[0]);
  store(side, values[1]);
  for (int lane = 0; lane < kLanes; ++lane) {
    task_.reached[first + lane] = static_cast<int>(values[0][lane]);
    task_.side[first + lane] = static_cast<int>(values[1][lane]);
  }
}

}  // namespace cognate::synthesis::COGNATE_ISA
