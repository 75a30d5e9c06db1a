/// @file How the coupler turns over boxes of turning four-bars, as Taylor models relative to a
/// direction that all samples share, one box in each lane. Include in kernels alone.
///
/// In the coordinates of proportion_box.hpp, with m = |2k − 1|, κ = k(1 − k), δ = m cos ξ and
/// s = cos η, the angle β between diagonal and coupler is given by
///
///     e^L = tan(β/2) = √((d − δ)(1 − s d)/((d + δ)(1 + s d))).
///
/// With a diagonal d̄ that is the same for all samples, L − L̄ is a sum of logarithms of 1 ± D/p,
/// D = d − d̄, so that β − β̄ is of the order of D: small where the crank is, and free of what all
/// samples have in common. Where the series do not converge, near change points above all, the
/// least and greatest β of the box serve.
#pragma once

#include "synthesis/lanes/coupler_ranges.hpp"
#include "synthesis/lanes/lanes_complex.hpp"
#include "synthesis/lanes/taylor_model.hpp"

namespace cognate::synthesis::COGNATE_ISA {

/// An angle as a model without its constant.
using AngleModel = Model<kAllSides>;

/// The turn of one sample's coupler over a box.
struct CouplerTurn {
  Real x, y;  ///< the direction at the middle, less the common one
  AngleModel turn;
  Real doubt[4];  ///< what each side adds to the rest, roughly, where the range is used
  Mask counted;   ///< false: nothing is known
};

/// Of the logarithms of a = 1 ± D/p: a bound of X at the middle, and Σ 1/a with the numerators'
/// magnitudes, which multiplies rounding.
struct LogSizes {
  Real constant, rounding;
};

/// What all samples share.
class CouplerModels {
 public:
  static constexpr unsigned kK = kFrameSide, kKX = kFrameSide | kFirstSide;
  static constexpr unsigned kKE = kFrameSide | kSecondSide, kKP = kFrameSide | kPhaseSide;

  /// `mean_cosine`: of the samples' crank angles, at the middle of the box.
  CouplerModels(const LanesBox& box, const Real& mean_cosine);

  /// At a crank angle of which half has this sine and cosine where the phase is zero.
  CouplerTurn at(const Real& half_sine, const Real& half_cosine) const;

 private:
  using Place = CrankPlace;
  Model<kKP> diagonal_turn(const Place& place) const;
  AngleModel coupler_change(const Place& place, const TangentRange& tangent, Mask& valid) const;
  Real change_rest(const AngleModel& bar, const AngleModel& to, const AngleModel& x,
                   const LogSizes& sizes, const Real& sine, const Real& tanh) const;
  void share_doubt(const Place& place, const Real& spread, CouplerTurn& turn) const;

  LanesBox box_;
  CouplerRanges ranges_;
  Model<kK> kappa_;
  Model<kSecondSide> inverse_;  ///< s
  Real reference_;              ///< c̄
  Model<kK> bar_;               ///< d̄
  Model<kKX> by_p1_, by_p2_;
  Model<kKE> by_p3_, by_p4_;
  Real steepness_;              ///< Σ 1/p
  Model<kKX | kKE> log_bar_;    ///< L̄ less its constant
  Model<kKX | kKE> angle_bar_;  ///< β̄ likewise
  Real sine_bar_, tanh_bar_;    ///< sin β̄ and tanh L̄ at the middle
  Mask bar_valid_;
  Real spread_bar_;  ///< by how much β̄ may differ from that of the middle
  /// Where β is known by its range alone: whether β̄ is then taken as a model, and what is unknown
  /// of it.
  Real keep_bar_, rest_bar_;
};

/// sin β and −cos β from tan(β/2) = n/m
inline void sine_and_tanh(const Real& n, const Real& m, Real& sine, Real& tanh) {
  const Real inverse = Real(1.0) / (n * n + m * m);
  sine = Real(2.0) * n * m * inverse;
  tanh = (n * n - m * m) * inverse;
}

/// |S‴| ≤ 1.757 S for S = 1/cosh, and |S⁗| ≤ 5 S.
inline constexpr double kThird = 1.757, kFourth = 5;

/// β = 2 arctan e^L by L, `fourth` a bound of S‴/24.
inline TaylorCoefficients angle_by_log(const Real& sine, const Real& tanh, const Real& fourth) {
  return {Real(0.0), sine, Real(-0.5) * sine * tanh,
          sine * (Real(2.0) * tanh * tanh - Real(1.0)) * Real(1.0 / 6), fourth};
}

inline CouplerModels::CouplerModels(const LanesBox& box, const Real& mean_cosine)
    : box_(box), ranges_(box) {
  const Real one(1.0), two(2.0);
  kappa_.at[0] = ranges_.product.middle;
  kappa_.at[1] = (one - two * box.k) * box.half_k;
  kappa_.at[2] = -box.half_k * box.half_k;
  kappa_.at[3] = kappa_.rest = Real(0.0);
  kappa_.measure();
  kappa_.pad(kappa_.size() + box.half_k);
  Model<kK> inner = kappa_;
  inner.at[0] = box.side * (two * box.k - one);
  inner.at[1] = box.side * two * box.half_k;
  inner.at[2] = inner.at[3] = inner.rest = Real(0.0);
  inner.measure();
  inner.pad(Real(3.0));
  const auto cosine = [&](const HalfAngles& angle) {
    return (angle.cosine - angle.sine) * (angle.cosine + angle.sine);
  };
  const auto sine = [&](const HalfAngles& angle) { return two * angle.sine * angle.cosine; };
  const Model<kKX> difference =
      inner * cosine_of_side<kFirstSide>(cosine(box.first), sine(box.first), box.first.half);
  inverse_ = cosine_of_side<kSecondSide>(cosine(box.second), sine(box.second), box.second.half);

  reference_ = smaller(Real(0.9), larger(Real(-0.9), mean_cosine));
  bar_valid_ = box.half_k < Real(2.0);
  bar_ = square_root(scaled(Real(-2.0) * (one + reference_), kappa_, one), bar_valid_);
  const Model<kKX> p1 = plus(bar_, Real(-1.0), difference), p2 = plus(bar_, one, difference);
  const Model<kKE> side = inverse_ * bar_;
  const Model<kKE> p3 = scaled(Real(-1.0), side, one), p4 = scaled(one, side, one);
  by_p1_ = reciprocal(p1, bar_valid_);
  by_p2_ = reciprocal(p2, bar_valid_);
  by_p3_ = reciprocal(p3, bar_valid_);
  by_p4_ = reciprocal(p4, bar_valid_);
  steepness_ = by_p1_.at[0] + by_p2_.at[0] + by_p3_.at[0] + by_p4_.at[0];
  const auto twice =
      plus(plus(logarithm(p1, bar_valid_), Real(-1.0), logarithm(p2, bar_valid_)), one,
           plus(logarithm(p3, bar_valid_), Real(-1.0), logarithm(p4, bar_valid_)));
  log_bar_ = scaled(Real(0.5), twice, Real(0.0));
  sine_and_tanh(root(p1.at[0] * p3.at[0]), root(p2.at[0] * p4.at[0]), sine_bar_, tanh_bar_);
  angle_bar_ = composed(angle_by_log(sine_bar_, tanh_bar_, Real(kThird / 24)), log_bar_);
  angle_bar_.pad((one + steepness_) * (one + log_bar_.spread()));

  const auto constant = [&](const Real& sum) { return LanesRange{sum, sum, sum}; };
  spread_bar_ = ranges_.tangent({constant(one - reference_), constant(one + reference_)}).spread();
  bar_valid_ = bar_valid_ && (spread_bar_ < Real(4.0)) && (steepness_ < Real(1e8)) &&
               (angle_bar_.rest < Real(4.0));
  // Where β is known by its range alone, β − β̄ is known best with β̄ as a model or by its range.
  const Real curved = angle_bar_.quadratic + angle_bar_.cubic + angle_bar_.rest;
  const Mask modelled = bar_valid_ && (curved < spread_bar_);
  keep_bar_ = choose(modelled, one, Real(0.0));
  rest_bar_ = choose(bar_valid_, choose(modelled, angle_bar_.rest, spread_bar_), Real(0.0));
  for (Real& coefficient : angle_bar_.at) coefficient = choose(bar_valid_, coefficient, Real(0.0));
  angle_bar_.measure();
}

/// The change of arg z, z = k − (1 − k)e^{iθ} along the diagonal: the imaginary part of
/// ln(1 + ζ) = ζ − ζ²/2 + ζ³/3 …, ζ = z/z₀ − 1.
inline Model<CouplerModels::kKP> CouplerModels::diagonal_turn(const Place& p) const {
  const Real crank = Real(1.0) - box_.k, turn = box_.phase.half, turn2 = turn * turn;
  const LanesComplex e{p.cosine, p.sine}, i_e{-p.sine, p.cosine};
  const Real inverse = Real(1.0) / p.square;
  const LanesComplex by_z{(box_.k - crank * p.cosine) * inverse, crank * p.sine * inverse};
  // The coefficients of ζ: a by k, b by the phase, then of higher degree.
  const LanesComplex one_e{Real(1.0) + e.x, e.y};
  const LanesComplex a = by_z * (box_.half_k * one_e);
  const LanesComplex ie_z = by_z * i_e, e_z = by_z * e;
  const LanesComplex b = (-crank * turn) * ie_z;
  const LanesComplex ab = (box_.half_k * turn) * ie_z;
  const LanesComplex bb = (Real(0.5) * crank * turn2) * e_z;
  const LanesComplex abb = (Real(-0.5) * box_.half_k * turn2) * e_z;
  const LanesComplex bbb = (Real(1.0 / 6) * crank * turn2 * turn) * ie_z;
  const LanesComplex a2 = a * a, b2 = b * b, a_b = a * b;
  Model<kKP> psi;
  psi.at[0] = Real(0.0);
  psi.at[1] = a.y;
  psi.at[2] = b.y;
  psi.at[3] = Real(-0.5) * a2.y;
  psi.at[4] = ab.y - a_b.y;
  psi.at[5] = bb.y - Real(0.5) * b2.y;
  psi.at[6] = Real(1.0 / 3) * (a * a2).y;
  psi.at[7] = (a * (a_b - ab)).y;
  psi.at[8] = (abb - a * bb + b * (a_b - ab)).y;
  psi.at[9] = (bbb - b * bb).y + Real(1.0 / 3) * (b * b2).y;
  psi.measure();
  const Real per_d = Real(1.0) / p.d;
  const Real l = about_size(a) + about_size(b), q = about_size(ab) + about_size(bb);
  const Real c = about_size(abb) + about_size(bbb);
  const Real r = (box_.half_k * turn * Real(1.0 / 6) + crank * turn2 * Real(1.0 / 24)) * turn2 *
                 per_d * Real(1 + kPad);
  const Real ec = c + r, g = q + ec, whole = l + g, whole2 = whole * whole;
  psi.rest = r + Real(0.5) * (Real(2.0) * l * ec + g * g) +
             Real(1.0 / 3) * g * (Real(3.0) * l * (l + g) + g * g) +
             whole2 * whole2 / (Real(4.0) * (Real(1.0) - whole));
  psi.rest = choose(whole < Real(0.9), psi.rest, Real(1e3));
  psi.pad(whole * (Real(1.0) + whole2) + (Real(1.0) + whole) * inverse);
  return psi;
}

/// The bound of what the series of β(L) − β(L̄) = ∫₀¹ S(L̄ + v X) X dv leaves, where S = 1/cosh L:
/// the product of X with a model of S that holds for all v at once.
inline Real CouplerModels::change_rest(const AngleModel& bar, const AngleModel& to,
                                       const AngleModel& x, const LogSizes& sizes, const Real& sine,
                                       const Real& tanh) const {
  const Real l = larger(bar.linear, to.linear), q = larger(bar.quadratic, to.quadratic);
  const Real c = larger(bar.cubic, to.cubic), r = larger(bar.rest, to.rest);
  const Real e = c + r, g = q + e, whole = l + g, whole2 = whole * whole;
  const Real s =
      choose(tanh * tanh_bar_ > Real(0.0), larger(sine, sine_bar_) * Real(1 + kPad), Real(1.0));
  const Real ss = l * l;
  const Real s_linear = s * l, s_quadratic = s * (q + Real(0.5) * ss);
  const Real s_cubic = s * (c + l * q + Real(kThird / 6) * ss * l);
  const Real s_rest = s * (r + Real(0.5) * (Real(2.0) * l * e + g * g) +
                           Real(kThird / 6) * g * (Real(3.0) * l * (l + g) + g * g) +
                           Real(kFourth / 24) * whole2 * whole2 / (Real(1.0) - whole));
  const Real s_whole = s + s_linear + s_quadratic + s_cubic;
  const Real x_whole = sizes.constant + x.spread();
  Real rest = s_linear * x.cubic + s_quadratic * (x.quadratic + x.cubic) +
              s_cubic * (x.linear + x.quadratic + x.cubic) + s_whole * x.rest +
              s_rest * (x_whole + x.rest);
  // The series are about β and β̄ at the middle, which the logarithms meet up to their rounding.
  const Real rounded = Real(1.0) + whole + Real(2.0) * s * whole * sizes.rounding;
  rest = rest * Real(1 + kPad) + Real(kPad) * (Real(1.0) + steepness_) * rounded;
  return choose(whole < Real(0.9), rest, Real(1e3));
}

/// The model of β − β̄.
inline AngleModel CouplerModels::coupler_change(const Place& p, const TangentRange& tangent,
                                                Mask& valid) const {
  const Real one(1.0);
  const Model<kPhaseSide> cosine = cosine_of_side<kPhaseSide>(p.cosine, p.sine, box_.phase.half);
  Model<kKP> square = scaled(Real(-2.0), kappa_ * scaled(one, cosine, one), one);
  square.at[0] = p.square;
  const Model<kKP> d = square_root(square, valid);
  const Model<kKP> change = kappa_ * scaled(Real(-2.0), cosine, Real(2.0) * reference_) *
                            reciprocal(plus(d, one, bar_), valid);
  const auto sided = inverse_ * change;
  LogSizes sizes{Real(0.0), Real(0.0)};
  const auto log_of = [&](const Real& sign, const auto& x) {
    const auto a = scaled(sign, x, one);
    const Real size = magnitude(x.at[0]);
    sizes.constant = sizes.constant + Real(0.5) * size / smaller(one, a.at[0]);
    sizes.rounding = sizes.rounding + (one + size) / a.at[0];
    return logarithm(a, valid);
  };
  const auto near = log_of(one, change * by_p1_), far = log_of(one, change * by_p2_);
  const auto low = log_of(Real(-1.0), sided * by_p3_), high = log_of(one, sided * by_p4_);
  const AngleModel x = scaled(
      Real(0.5), plus(plus(near, Real(-1.0), far), one, plus(low, Real(-1.0), high)), Real(0.0));
  AngleModel bar = plus(x, one, log_bar_);
  const AngleModel to = bar;
  bar.linear = log_bar_.linear;
  bar.quadratic = log_bar_.quadratic;
  bar.cubic = log_bar_.cubic;
  bar.rest = log_bar_.rest;
  Real sine, tanh;
  sine_and_tanh(tangent.n.middle, tangent.m.middle, sine, tanh);
  AngleModel turn = composed(angle_by_log(sine, tanh, Real(0.0)), to);
  const Real rounded = turn.spread() + angle_bar_.spread();
  turn = plus(turn, Real(-1.0), angle_bar_);
  turn.rest = change_rest(bar, to, x, sizes, sine, tanh);
  turn.pad(rounded);
  return turn;
}

/// Shares what is unknown of a direction known by its range among the sides.
inline void CouplerModels::share_doubt(const Place& p, const Real& spread,
                                       CouplerTurn& turn) const {
  ranges_.share(p, turn.doubt);
  for (Real& doubt : turn.doubt) doubt = spread * doubt;
  // Of β̄ where that is known by its range.
  const Real of_bar =
      choose(keep_bar_ > Real(0.0), Real(0.0), rest_bar_) / (angle_bar_.linear + Real(1e-30));
  for (int i = 0; i < 3; ++i) {
    turn.doubt[i] = turn.doubt[i] + of_bar * magnitude(angle_bar_.at[1 + i]);
  }
}

inline CouplerTurn CouplerModels::at(const Real& half_sine, const Real& half_cosine) const {
  const Place p = ranges_.place(half_sine, half_cosine);
  const TangentRange range = ranges_.tangent(p.versines);
  Mask valid = bar_valid_;
  AngleModel change = coupler_change(p, range, valid);
  const Real own = change.quadratic + change.cubic + change.rest;
  const Real spread = range.spread(), zero(0.0);
  const Real known = spread + rest_bar_;
  const Mask good = valid && (own < Real(1e2));
  const Mask ranged = !(good && (own < Real(0.01) || own < known));
  for (Real& coefficient : change.at) coefficient = choose(ranged, zero, coefficient);
  change.measure();
  const Real change_size = change.spread() + angle_bar_.spread();
  const Real rest = choose(ranged, known, change.rest);
  const Model<kKP> psi = diagonal_turn(p);
  CouplerTurn result;
  result.turn = plus(plus(psi, box_.assembly, change),
                     choose(ranged, -box_.assembly * keep_bar_, zero), angle_bar_);
  result.turn.rest = psi.rest + rest;
  const Real square_low = ranges_.inner.low * ranges_.inner.low +
                          Real(2.0) * ranges_.product.high * p.versines.versine.low;
  result.turn.pad(Real(4.0) + result.turn.spread() + psi.spread() + change_size +
                  Real(4.0) / square_low);
  result.counted = (square_low > Real(1e-8)) && (result.turn.rest < Real(1.0)) &&
                   (result.turn.spread() < Real(1e3));
  share_doubt(p, spread, result);
  for (Real& doubt : result.doubt) doubt = choose(ranged && result.counted, doubt, Real(0.0));

  const Real n = range.n.middle, m = range.m.middle, inverse = Real(1.0) / (n * n + m * m);
  const LanesComplex beta{(m - n) * (m + n) * inverse, box_.assembly * Real(2.0) * n * m * inverse};
  const Real per_d = Real(1.0) / p.d, crank = Real(1.0) - box_.k;
  const LanesComplex diagonal{(box_.k - crank * p.cosine) * per_d, -crank * p.sine * per_d};
  const LanesComplex u = diagonal * beta;
  const Real per_length = Real(1.0) / root(u.x * u.x + u.y * u.y);
  result.x = choose(result.counted, u.x * per_length, Real(1.0));
  result.y = choose(result.counted, u.y * per_length, Real(0.0));
  for (Real& coefficient : result.turn.at) {
    coefficient = choose(result.counted, coefficient, Real(0.0));
  }
  result.turn.rest = choose(result.counted, result.turn.rest, Real(1.0));
  return result;
}

}  // namespace cognate::synthesis::COGNATE_ISA
