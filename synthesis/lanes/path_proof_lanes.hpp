/// @file Whether the error of a timed path surely exceeds a target over boxes of proportions, one
/// in each lane. Include in kernels alone.
///
/// As in path_bound.hpp the error is at least F where H(u) = κ(U(u) + λ) − |b(u)|² ≥ 0, a form in
/// the directions u of the coupler. With u as in path_forms.hpp it is taken apart by degree: up to
/// the second exactly, the third by its coefficients, the fourth and the rest by norms.
#pragma once

#include "synthesis/lanes/least_over_lanes.hpp"
#include "synthesis/lanes/path_forms.hpp"

namespace cognate::synthesis::COGNATE_ISA {

inline constexpr int kPathSweeps = 24;

/// What is left of H's least value over the box, at least and about, κ and Σ ‖∇H‖, where q's limit
/// has the multiplier `on_point`.
struct PathExcess {
  Real least, about, kappa, gradients;
};

class PathProof {
 public:
  explicit PathProof(const PathProofTask& task) : task_(task), samples_(task) {}

  /// Judges the boxes [first, first + kLanes).
  void judge(int first);

 private:
  LanesBox load_box(int first) const;
  PathExcess excess(const PathForms& forms, double target) const;
  PathExcess excess_with(const PathForms& forms, double target, const Real& on_point) const;
  Real best_side(const LanesBox& box, const PathForms& forms, const PathExcess& excess) const;

  const PathProofTask& task_;
  PathSamples samples_;
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
  const LanesLeast least = least_over_box(h, wanted, kPathSweeps);
  result.least = choose(f.valid && kappa > zero, least.bound - wanted, Real(-1e300));
  result.about = least.about - wanted;
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
  const Real added = Real(-2.0) * result.about / result.kappa;
  const Mask again = result.least < zero && added > zero && result.kappa > zero &&
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
  samples_.enclose(box);
  const Real zero(0.0), one(1.0), two(2.0);
  PathForms forms = samples_.sums();
  PathExcess found = excess(forms, task_.target);
  Real reached = choose(found.least >= zero, two, zero), side(-1.0);
  if (any(reached < two)) {
    side = choose(reached < two, best_side(box, forms, found), side);
    samples_.weigh_by_rest();
    forms = samples_.sums();
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
