/// @file Prescribed-timing path generation with the linear unknowns eliminated.
///
/// With the crank at θⱼ and the coupler at φⱼ from the frame line, a coupler point is
/// Pⱼ = t + s e^{iθⱼ} + q e^{iφⱼ} with complex t (crank pivot), s (crank length and direction of
/// the frame) and q (coupler point). Given the ratios of the links to the crank, φⱼ is known and
/// the least squares in t, s, q is a Hermitian system of at most three unknowns.
///
/// Plain templates without the standard library, so that they may be compiled for each instruction
/// set apart (see path_screen.hpp).
#pragma once

#include "analysis/linkage/closure.hpp"

namespace cognate::synthesis {

/// Target points and what is fixed. Points and lengths are in one unit of order of the path's size.
struct SeparableTarget {
  const double* half_cos = nullptr;  ///< of half the crank's increments, one for each point
  const double* half_sin = nullptr;
  const double* x = nullptr;  ///< targets; relative to the crank pivot if that is fixed, else to
  const double* y = nullptr;  ///< their weighted centroid
  const double* weight = nullptr;
  int count = 0;
  double weight_sum = 0;
  double squares = 0;  ///< Σ weight·|z|²
  bool pivot_fixed = false;
  /// The direction of the frame: free, or fixed to (direction_cos, direction_sin), or minus the
  /// phase (crank angles counted from the x axis).
  enum class Direction { free, fixed, minus_phase } direction = Direction::free;
  double direction_cos = 1, direction_sin = 0;
  double least[4] = {}, greatest[4] = {};  ///< bounds on crank, coupler, rocker, frame
};

/// The best linear unknowns for one design and their weighted sum of squares. Where no crank length
/// satisfies all bounds, the one that violates the lower bounds least is taken. `error` is not a
/// number where the linkage does not close at a target.
template <class T>
struct SeparableFit {
  T error{};
  T crank{};
  Vec2<T> frame_direction, coupler_point, pivot;  ///< coupler_point in the plane's axes: q
};

/// `ratios`: lengths with crank = 1. `phase_half`: e^{iθ₀/2}, added to every increment.
template <class T>
SeparableFit<T> separable_fit(const SeparableTarget& target, const Lengths<T>& ratios,
                              const Vec2<T>& phase_half, const T& assembly) {
  using std::max;
  using std::min;
  using std::sqrt;
  // One half-circle form serves the whole circle: screening needs no last digits.
  const HalfClosure<T> closure(ratios, +1);
  const Vec2<T> zero{T(0), T(0)};
  Vec2<T> sum1 = zero, sum2 = zero, mixed = zero, rhs1 = zero, rhs2 = zero;
  for (int j = 0; j < target.count; ++j) {
    const Vec2<T> half = Vec2<T>{T(target.half_cos[j]), T(target.half_sin[j])} * phase_half;
    const T versine = T(2) * half.y * half.y;
    const T sin = T(2) * half.x * half.y;
    const Vec2<T> e1{T(1) - versine, sin};
    const Vec2<T> e2 = closure.at(sin, versine, assembly).coupler;
    const T w(target.weight[j]);
    const Vec2<T> wz{w * T(target.x[j]), w * T(target.y[j])};
    sum1 = sum1 + w * e1;
    sum2 = sum2 + w * e2;
    mixed = mixed + w * (conj(e1) * e2);
    rhs1 = rhs1 + conj(e1) * wz;
    rhs2 = rhs2 + conj(e2) * wz;
  }
  // Gram matrix of (e1, e2), with the free pivot t eliminated.
  const T total(target.weight_sum);
  const T inverse_total = T(1) / total;
  T g11 = total, g22 = total;
  if (!target.pivot_fixed) {
    g11 = total - inverse_total * squared_norm(sum1);
    g22 = total - inverse_total * squared_norm(sum2);
    mixed = mixed - inverse_total * (conj(sum1) * sum2);
  }
  // Eliminate q: what is left of the error is squares' − 2 Re(conj(s)·slope) + curvature·|s|².
  const T inverse22 = T(1) / g22;
  const T curvature = g11 - inverse22 * squared_norm(mixed);
  const Vec2<T> slope = rhs1 - inverse22 * (mixed * rhs2);
  const T without_crank = T(target.squares) - inverse22 * squared_norm(rhs2);

  Vec2<T> direction;
  T along;
  if (target.direction == SeparableTarget::Direction::free) {
    along = sqrt(squared_norm(slope));
    direction = (T(1) / along) * slope;
  } else {
    direction = target.direction == SeparableTarget::Direction::fixed
                    ? Vec2<T>{T(target.direction_cos), T(target.direction_sin)}
                    : conj(phase_half * phase_half);
    along = dot(slope, direction);
  }
  T low(target.least[0]), high(target.greatest[0]);
  const T* others[3] = {&ratios.coupler, &ratios.rocker, &ratios.frame};
  for (int k = 0; k < 3; ++k) {
    low = max(low, T(target.least[k + 1]) / *others[k]);
    high = min(high, T(target.greatest[k + 1]) / *others[k]);
  }
  const T crank = max(low, min(high, along / curvature));

  SeparableFit<T> fit;
  fit.crank = crank;
  fit.error = without_crank + crank * (curvature * crank - (along + along));
  fit.frame_direction = direction;
  const Vec2<T> s = crank * direction;
  fit.coupler_point = inverse22 * (rhs2 - conj(mixed) * s);
  fit.pivot = -(inverse_total * (sum1 * s + sum2 * fit.coupler_point));
  return fit;
}

}  // namespace cognate::synthesis
