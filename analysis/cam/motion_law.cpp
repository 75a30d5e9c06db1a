#include "analysis/cam/motion_law.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "analysis/cam/spline_law.hpp"
#include "analysis/cam/universal_law.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::cam {
namespace {

constexpr int kMost = static_cast<int>(MotionPiece<double>::kMostTerms);

// More digits than the coefficients keep, where the machine has them.
using Real = long double;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, kMost, 1>;

/// The segment's conditions, and those of its ends that are implied; nothing where they cannot be
/// met for a reason that shows.
std::vector<MotionCondition> all_conditions(const MotionSegment& segment) {
  std::vector<MotionCondition> conditions = segment.conditions;
  for (const MotionCondition& end :
       {MotionCondition{0, 0, 0}, MotionCondition{1, 0, segment.rise}}) {
    const auto same = [&](const auto& condition) {
      return condition.at == end.at && condition.order == 0;
    };
    if (std::ranges::none_of(conditions, same)) conditions.push_back(end);
  }
  if (conditions.size() > static_cast<std::size_t>(kMost)) return {};
  for (const auto& [at, order, value] : conditions) {
    if (!(at >= 0 && at <= 1) || order < 0 || order >= kMost || !std::isfinite(value)) return {};
  }
  return conditions;
}

/// The derivatives `order` of the Chebyshev polynomials T₀, T₁, ... at x, by Leibniz' rule in
/// Tₖ = 2x Tₖ₋₁ − Tₖ₋₂.
Vector chebyshev_derivatives(Real x, int order, Eigen::Index count) {
  Vector lower = Vector::Zero(count), here(count);
  for (int m = 0; m <= order; ++m) {
    for (Eigen::Index k = 0; k < count; ++k) {
      if (k == 0) {
        here[k] = m == 0 ? 1 : 0;
      } else if (k == 1) {
        here[k] = m == 0 ? x : m == 1 ? 1 : 0;
      } else {
        here[k] = 2 * x * here[k - 1] - here[k - 2] + 2 * static_cast<Real>(m) * lower[k - 1];
      }
    }
    lower = here;
  }
  return here;
}

/// Coefficients of powers of x from those of Chebyshev polynomials.
Vector powers(const Vector& chebyshev) {
  const Eigen::Index count = chebyshev.size();
  Vector sum = Vector::Zero(count), before = Vector::Zero(count), here = Vector::Unit(count, 0);
  for (Eigen::Index k = 0; k < count; ++k) {
    sum += chebyshev[k] * here;
    Vector next = -before;
    next.tail(count - 1) += (k == 0 ? 1 : 2) * here.head(count - 1);
    before = here;
    here = next;
  }
  return sum;
}

/// One equation for each condition, in Chebyshev coefficients, each row of greatest entry 1;
/// displacements in units of `unit`.
struct Equations {
  Matrix rows;
  Vector values;
};

Equations equations(const std::vector<MotionCondition>& conditions, double over, double unit) {
  const auto count = static_cast<Eigen::Index>(conditions.size());
  Equations system{Matrix(count, count), Vector(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [at, order, value] = conditions[static_cast<std::size_t>(i)];
    const Vector row = chebyshev_derivatives(2 * static_cast<Real>(at) - 1, order, count);
    const Real size = row.cwiseAbs().maxCoeff();
    const Real per = size > 0 ? 1 / size : 0;
    system.rows.row(i) = per * row.transpose();
    system.values[i] = per * (static_cast<Real>(value) / static_cast<Real>(unit)) *
                       std::pow(static_cast<Real>(over) / 2, static_cast<Real>(order));
  }
  return system;
}

/// The unit in which the coefficients are kept: the rise, so that those of simple laws are short.
double unit_of(const std::vector<MotionCondition>& conditions, double rise, double over) {
  if (rise != 0) return rise;
  double greatest = 0;
  for (const auto& [at, order, value] : conditions) {
    greatest = std::max(greatest, std::abs(value) * std::pow(over / 2, order));
  }
  return greatest > 0 ? greatest : 1;
}

/// `append_pieces` of a polynomial: one piece. False where a condition is given twice, lies outside
/// the segment, or where the conditions have no polynomial or many (Pólya's condition fails),
/// reported by the condition number of their equations.
bool append_polynomial(const MotionSegment& segment, double begin, double start, int index,
                       std::vector<MotionPiece<double>>& pieces) {
  constexpr Real kLeastReciprocalCondition = 1e-12L, kGreatestResidual = 1e-9L;
  const std::vector<MotionCondition> conditions = all_conditions(segment);
  if (conditions.empty()) return false;
  const double unit = unit_of(conditions, segment.rise, segment.over);
  const auto [rows, values] = equations(conditions, segment.over, unit);
  const Eigen::FullPivLU<Matrix> factors(rows);
  if (!factors.isInvertible() || !(factors.rcond() >= kLeastReciprocalCondition)) return false;
  Vector chebyshev = factors.solve(values);
  chebyshev += factors.solve(values - rows * chebyshev);
  const Real residual = (values - rows * chebyshev).cwiseAbs().maxCoeff();
  if (!(residual <= kGreatestResidual * values.cwiseAbs().maxCoeff())) return false;

  const Vector coefficients = powers(chebyshev);
  MotionPiece<double> piece{.begin = begin, .span = segment.over, .offset = start, .scale = unit};
  piece.segment = index;
  piece.terms = static_cast<int>(coefficients.size());
  for (Eigen::Index k = 0; k < coefficients.size(); ++k) {
    const auto coefficient = static_cast<double>(coefficients[k]);
    if (!std::isfinite(coefficient)) return false;
    piece.polynomial[static_cast<std::size_t>(k)] = coefficient;
  }
  pieces.push_back(piece);
  return true;
}

using Piece = MotionPiece<double>;

Piece whole(std::initializer_list<double> polynomial,
            std::initializer_list<Sinusoid<double>> sinusoids = {}) {
  return unit_piece<double>(0, 1, polynomial, sinusoids);
}

/// (1 − cos πu)/2 − (1 − cos 2πu)/8: at rest and without acceleration at the bottom, where the
/// follower dwells, but not at the top, where the return follows at once. Rothbart, Cams, 1956.
Piece double_harmonic(bool is_return) {
  const Piece up = whole({0.375}, {{-0.5, 1, 0.5}, {0.125, 2, 0.5}});
  return is_return ? mirrored(up) : up;
}

void append_halves(const Piece& first, const Place<double>& place, std::vector<Piece>& pieces) {
  pieces.push_back(placed(first, place));
  pieces.push_back(placed(mirrored(first), place));
}

void append_universal(const UniversalShape<double>& shape, const Place<double>& place,
                      std::vector<Piece>& pieces) {
  append_universal<double>(shape, place.begin, place.over, place.start, place.rise, place.segment,
                           pieces);
}

/// Whether the shares are shares of 1, to rounding.
bool is_valid(const UniversalShape<double>& shape) {
  return shape.sine >= 0 && shape.constant >= 0 && shape.cosine >= 0 &&
         shape.sine + shape.constant + shape.cosine <= 1 + kLeastShare;
}

}  // namespace

bool append_pieces(const MotionSegment& segment, double begin, double start, int index,
                   std::vector<Piece>& pieces) {
  const Place<double> place{begin, segment.over, start, segment.rise, index};
  const auto append = [&](const Piece& piece) { pieces.push_back(placed(piece, place)); };
  switch (segment.law) {
    case MotionLaw::dwell:
      append(whole({}));
      return true;
    case MotionLaw::constant_velocity:
      append(whole({0.5, 0.5}));
      return true;
    case MotionLaw::constant_acceleration:
      append_halves(unit_piece<double>(0, 0.5, {0.125, 0.25, 0.125}), place, pieces);
      return true;
    case MotionLaw::harmonic:
      append(whole({0.5}, {{-0.5, 1, 0.5}}));
      return true;
    case MotionLaw::cycloidal:
      append(whole({0.5, 0.5}, {{-0.5 / pi_of<double>(), 2, 0}}));
      return true;
    case MotionLaw::polynomial_345:
      append(whole({0.5, 15.0 / 16, 0, -10.0 / 16, 0, 3.0 / 16}));
      return true;
    case MotionLaw::polynomial_4567:
      append(whole({0.5, 35.0 / 32, 0, -35.0 / 32, 0, 21.0 / 32, 0, -5.0 / 32}));
      return true;
    case MotionLaw::modified_sine:
      append_universal({0.25, 0, 0.75}, place, pieces);
      return true;
    case MotionLaw::modified_trapezoid:
      append_universal({0.25, 0.5, 0.25}, place, pieces);
      return true;
    case MotionLaw::modified_constant_velocity:
      append_universal({0.125, 0, 0.375}, place, pieces);
      return true;
    case MotionLaw::double_harmonic:
      append(double_harmonic(segment.rise < 0));
      return true;
    case MotionLaw::universal:
      if (!is_valid(segment.shape)) return false;
      append_universal(segment.shape, place, pieces);
      return true;
    case MotionLaw::polynomial:
      return append_polynomial(segment, begin, start, index, pieces);
    case MotionLaw::spline:
      return append_spline(segment, begin, start, index, pieces);
  }
  return false;
}

std::optional<PeakFactors> handbook_factors(MotionLaw law) {
  switch (law) {
    case MotionLaw::dwell:
      return PeakFactors{0, 0, 0};
    case MotionLaw::constant_velocity:
      return PeakFactors{1, kInfinity, kInfinity};
    case MotionLaw::constant_acceleration:
      return PeakFactors{2, 4, kInfinity};
    case MotionLaw::harmonic:
      return PeakFactors{1.5708, 4.9348, 15.503};
    case MotionLaw::cycloidal:
      return PeakFactors{2, 6.2832, 39.478};
    case MotionLaw::polynomial_345:
      return PeakFactors{1.875, 5.7735, 60};
    case MotionLaw::polynomial_4567:
      return PeakFactors{2.1875, 7.5132, 52.5};
    case MotionLaw::modified_sine:
      return PeakFactors{1.7596, 5.5280, 69.47};
    case MotionLaw::modified_trapezoid:
      return PeakFactors{2, 4.8881, 61.43};
    case MotionLaw::modified_constant_velocity:
      return PeakFactors{1.28, 8.01, 201.4};
    case MotionLaw::double_harmonic:
      return PeakFactors{2.04, 9.87, 42.4};
    case MotionLaw::universal:
    case MotionLaw::polynomial:
    case MotionLaw::spline:
      return std::nullopt;
  }
  return std::nullopt;
}

template void append_universal(const UniversalShape<double>& shape, const double& begin,
                               const double& over, const double& start, const double& rise,
                               int index, std::vector<Piece>& pieces);

}  // namespace cognate::cam
