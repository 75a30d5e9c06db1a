#include "synthesis/optimise/check_derivatives.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "synthesis/optimise/dense_model.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::VectorXd;

constexpr int kLevels = 8;

/// Residuals, then constraints.
bool values_at(const Model& model, std::span<const double> x, VectorXd& values) {
  VectorXd residuals(model.residual_count()), constraints(model.constraint_count());
  if (!model.residuals(x, view(residuals), {}, {})) return false;
  model.constraints(x, view(constraints), {});
  values.resize(residuals.size() + constraints.size());
  values << residuals, constraints;
  return values.allFinite();
}

/// The model's own derivatives of residuals and constraints by all variables.
RowMatrix analytic_derivatives(const Model& model, std::span<const double> x) {
  const int rows = model.residual_count(), limits = model.constraint_count();
  const int globals = model.global_count();
  RowMatrix jacobian(rows, globals), limit_jacobian(limits, globals);
  VectorXd residuals(rows), constraints(limits), local(model.local_count() > 0 ? rows : 0);
  model.residuals(x, view(residuals), view(jacobian), view(local));
  model.constraints(x, view(constraints), view(limit_jacobian));
  RowMatrix out = RowMatrix::Zero(rows + limits, globals + model.local_count());
  out.topLeftCorner(rows, globals) = jacobian;
  out.bottomLeftCorner(limits, globals) = limit_jacobian;
  const std::span<const int> local_of = model.local_of_residual();
  for (int row = 0; row < local.size(); ++row) {
    if (local_of[row] >= 0) out(row, globals + local_of[row]) = local[row];
  }
  return out;
}

/// Ridders' table for one column: differences at steps h, h/2, h/4, …, extrapolated; for each row
/// the entry whose neighbours agree best. False where the model has no value around x.
bool numeric_column(const Model& model, std::span<const double> x, int column, VectorXd& best) {
  std::vector<double> probe(x.begin(), x.end());
  std::array<VectorXd, kLevels> previous, current;
  VectorXd above, below, error;
  double step = 1e-2 * model.variables()[column].scale;
  bool any = false;
  for (int level = 0, tries = 0; level < kLevels && tries < 2 * kLevels; ++tries, step /= 2) {
    probe[column] = x[column] + step;
    const double high = probe[column];
    const bool has_above = values_at(model, probe, above);
    probe[column] = x[column] - step;
    if (!has_above || !values_at(model, probe, below)) continue;
    current[0] = (above - below) / (high - probe[column]);
    if (!any) {
      best = current[0];
      error.setConstant(best.size(), std::numeric_limits<double>::infinity());
      any = true;
    }
    double factor = 1;
    for (int order = 1; order <= level; ++order) {
      factor *= 4;
      current[order] = (factor * current[order - 1] - previous[order - 1]) / (factor - 1);
      const VectorXd doubt = (current[order] - current[order - 1])
                                 .cwiseAbs()
                                 .cwiseMax((current[order] - previous[order - 1]).cwiseAbs());
      for (int row = 0; row < doubt.size(); ++row) {
        if (doubt[row] >= error[row]) continue;
        error[row] = doubt[row];
        best[row] = current[order][row];
      }
    }
    previous = current;
    ++level;
  }
  return any;
}

}  // namespace

std::string DerivativeError::describe(const Model& model) const {
  if (!has_value) return "the model has no value here";
  if (variable < 0) return "no derivatives to compare";
  std::ostringstream out;
  out.precision(17);
  out << (part == Part::residuals ? "residual " : "constraint ") << row << " by "
      << model.variables()[variable].name << ": " << analytic << ", numerically " << numeric
      << " (relative " << relative << ")";
  return out.str();
}

DerivativeError check_derivatives(const Model& model, std::span<const double> x) {
  DerivativeError worst;
  VectorXd values;
  if (!values_at(model, x, values)) return worst;
  const RowMatrix analytic = analytic_derivatives(model, x);
  VectorXd scale(analytic.cols());
  for (int j = 0; j < scale.size(); ++j) scale[j] = model.variables()[j].scale;
  const VectorXd size = (analytic * scale.asDiagonal())
                            .cwiseAbs()
                            .rowwise()
                            .maxCoeff()
                            .cwiseMax(values.cwiseAbs())
                            .cwiseMax(1e-12);
  worst.has_value = true;
  VectorXd numeric;
  for (int j = 0; j < scale.size(); ++j) {
    if (!numeric_column(model, x, j, numeric)) return {};
    for (int i = 0; i < numeric.size(); ++i) {
      const double relative = std::abs(analytic(i, j) - numeric[i]) * scale[j] / size[i];
      if (relative < worst.relative) continue;  // a NaN counts as worst
      const bool is_residual = i < model.residual_count();
      worst.part =
          is_residual ? DerivativeError::Part::residuals : DerivativeError::Part::constraints;
      worst.row = is_residual ? i : i - model.residual_count();
      worst.variable = j;
      worst.analytic = analytic(i, j);
      worst.numeric = numeric[i];
      worst.relative = relative;
      if (std::isnan(relative)) return worst;
    }
  }
  return worst;
}

}  // namespace cognate::synthesis
