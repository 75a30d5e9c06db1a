#include "analysis/cam/polynomial_law.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

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

}  // namespace

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

}  // namespace cognate::cam
