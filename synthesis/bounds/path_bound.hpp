/// @file A lower bound of the error of timed path generation over a box of proportions.
///
/// A coupler point is P = t + s·e + q·u with e the crank's turning, known, and u = e^{iφ} the
/// coupler's direction; complex t, s, q enter linearly. With t, s and q eliminated the error is
/// Z − |b(u)|²/U(u), where U is a Hermitian form and b is linear in the vector u of directions. So
/// the error is at least F wherever H(u) = (Z − F) U(u) − |b(u)|² ≥ 0: a form in u alone. Over a
/// box u is affine in the position in the box up to a small rest (see proportion_box.hpp), and H is
/// a quadratic of four variables up to a term of the residuals times that rest. The rest is of
/// second order, so that the bound is good near minima, too, where errors are small.
///
/// Limits of s and q enter by Lagrange multipliers, best for the middle of the box: for any of
/// their values the bound holds.
#pragma once

#include <complex>
#include <memory>
#include <utility>
#include <vector>

#include "synthesis/bounds/branch_and_bound.hpp"
#include "synthesis/bounds/proportion_box.hpp"
#include "synthesis/bounds/proportion_limits.hpp"

namespace cognate::synthesis {

/// What is desired. Points in a unit of the path's size, relative to the crank pivot where that is
/// fixed, else to any point near them.
struct TimedPath {
  std::vector<std::complex<double>> points;
  std::vector<double> crank_angles;  ///< from A→D where the phase is zero
  std::vector<double> weights;       ///< not negative, one positive
  bool pivot_fixed = false;
  /// Whether the crank's direction at angle zero in the plane is known: then it is the x axis of
  /// `points`.
  bool direction_fixed = false;
  LengthLimits lengths;
  double farthest_point = 0;  ///< greatest distance of the coupler point from B, possibly infinite
};

/// Bounds of Σ weight·|distance|² over boxes.
class PathBound {
 public:
  PathBound(TimedPath path, const ProportionLimits& limits);

  /// No more than the error anywhere in the box, at most `wanted`, and best where near that.
  /// Infinite where no linkage of the box satisfies the limits.
  BoxBound operator()(const ProportionBox& box, double wanted) const;

 private:
  using Complex = std::complex<double>;
  struct Target;
  struct Forms;
  struct Multipliers;
  struct Bounded;
  struct Loss;

  /// v and the rest; sets the weights to zero where the rest is too large to be of use.
  Forms linear_part(const std::vector<DirectionRange>& directions,
                    std::vector<double>& weights) const;
  void add_sums(const Target& target, Forms& forms) const;
  Multipliers crank_multipliers(const Target& target, const Forms& forms, double low, double high,
                                double on_point) const;
  Multipliers multipliers(const Target& target, const Forms& forms, double low, double high) const;
  /// The bound for a crank length between `low` and `high`.
  double bound(const std::vector<DirectionRange>& directions, double low, double high,
               double wanted) const;
  double bound(const Target& target, Forms& forms, double low, double high, double wanted) const;
  Loss loss(const Target& target, const Forms& forms, const Multipliers& multipliers,
            const std::array<Complex, kBoxSides + 1>& b, double kappa) const;
  Bounded bounded(const Target& target, const Forms& forms, const Multipliers& multipliers,
                  double wanted) const;

  TimedPath path_;
  ProportionLimits limits_;
  std::shared_ptr<const Target> target_;  ///< of all points
};

}  // namespace cognate::synthesis
