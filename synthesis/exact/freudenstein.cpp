#include "synthesis/exact/freudenstein.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

constexpr double kSingularCondition = 1e14;

Vector row(const AnglePair& pair) {
  return {std::cos(pair.output), std::cos(pair.output - pair.input), 1.0};
}

double residual(const AnglePair& pair, const Vector& p) {
  return row(pair).dot(p) - std::cos(pair.input);
}

double one_norm(const Matrix& m) {
  return m.cwiseAbs().colwise().sum().maxCoeff();
}

/// The solution of m·p = right with one step of refinement, and the condition of m.
std::optional<FreudensteinRatios> solve(const Matrix& m, const Vector& right) {
  const Eigen::FullPivLU<Matrix> lu(m);
  if (!lu.isInvertible()) return std::nullopt;
  const double condition = one_norm(m) * one_norm(lu.inverse());
  if (!(condition <= kSingularCondition)) return std::nullopt;
  Vector p = lu.solve(right);
  p -= lu.solve(m * p - right);
  return FreudensteinRatios{{p[0], p[1], p[2]}, 0, condition};
}

FreudensteinRatios with_residual(FreudensteinRatios ratios, std::span<const AnglePair> pairs) {
  const Vector p(ratios.p.data());
  for (const AnglePair& pair : pairs) {
    ratios.residual = std::max(ratios.residual, std::abs(residual(pair, p)));
  }
  return ratios;
}

}  // namespace

std::optional<FreudensteinRatios> freudenstein_exact(std::span<const AnglePair, 3> pairs) {
  Matrix m;
  Vector right;
  for (int i = 0; i < 3; ++i) {
    m.row(i) = row(pairs[i]);
    right[i] = std::cos(pairs[i].input);
  }
  const auto ratios = solve(m, right);
  if (!ratios) return std::nullopt;
  return with_residual(*ratios, pairs);
}

std::optional<FreudensteinRatios> freudenstein_fit(std::span<const AnglePair> pairs,
                                                   std::span<const double> weights) {
  Matrix normal = Matrix::Zero();
  Vector right = Vector::Zero();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Vector a = row(pairs[i]);
    const Vector weighted = (weights.empty() ? 1.0 : weights[i]) * a;
    normal += weighted * a.transpose();
    right += std::cos(pairs[i].input) * weighted;
  }
  const auto ratios = solve(normal, right);
  if (!ratios) return std::nullopt;
  return with_residual(*ratios, pairs);
}

FreudensteinLinkage freudenstein_linkage(const std::array<double, 3>& p) {
  FreudensteinLinkage result;
  if (p[0] == 0) {
    result.outcome = FreudensteinOutcome::no_rocker;
    return result;
  }
  const double m = p[0];
  const double n = -p[0] / p[1];
  if (!std::isfinite(n)) {
    result.outcome = FreudensteinOutcome::infinite_frame;
    return result;
  }
  result.coupler_squared = m * m + n * n + 1 - 2 * n * p[2];
  if (!(result.coupler_squared > 0)) {
    result.outcome = FreudensteinOutcome::imaginary_coupler;
    return result;
  }
  result.links = {1, std::sqrt(result.coupler_squared), std::abs(m), std::abs(n)};
  result.input_turn = n < 0 ? kPi : 0;
  result.output_turn = (n < 0) != (m < 0) ? kPi : 0;
  return result;
}

}  // namespace cognate::synthesis
