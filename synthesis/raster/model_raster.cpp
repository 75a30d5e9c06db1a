#include "synthesis/raster/model_raster.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "synthesis/search/multi_start.hpp"

namespace cognate::synthesis {
namespace {

double folded(const Model& model, std::span<const double> r) {
  if (model.objective() == Objective::sum_of_squares) {
    return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
  }
  double most = 0;
  for (const double value : r) most = std::max(most, std::abs(value));
  return most;
}

double violation_at(const Model& model, std::span<const double> x) {
  std::vector<double> c(static_cast<std::size_t>(model.constraint_count()));
  model.constraints(x, c, {});
  double most = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const bool equality = i < static_cast<std::size_t>(model.equality_count());
    most = std::max(most, equality ? std::abs(c[i]) : -c[i]);
  }
  return most;
}

}  // namespace

double AxisVariable::of_value(double value) const {
  const double linear = (value - offset) / scale;
  return is_logarithm ? std::log(linear) : linear;
}

double AxisVariable::to_value(double variable) const {
  return offset + scale * (is_logarithm ? std::exp(variable) : variable);
}

RestrictedModel::RestrictedModel(const Model& inner, std::span<const double> lower,
                                 std::span<const double> upper)
    : inner_(inner), fixed_(lower.begin(), lower.end()) {
  const auto all = inner.variables();
  const auto globals = static_cast<std::size_t>(inner.global_count());
  for (std::size_t i = 0; i < globals; ++i) {
    if (lower[i] == upper[i]) continue;
    free_.push_back(i);
    variables_.push_back({all[i].name, lower[i], upper[i], all[i].scale});
  }
  variables_.insert(variables_.end(), all.begin() + static_cast<std::ptrdiff_t>(globals),
                    all.end());
}

std::vector<double> RestrictedModel::inwards(std::span<const double> x) const {
  std::vector<double> picked;
  for (const std::size_t i : free_) picked.push_back(x[i]);
  picked.insert(picked.end(), x.begin() + static_cast<std::ptrdiff_t>(fixed_.size()), x.end());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    picked[i] = std::clamp(picked[i], variables_[i].lower, variables_[i].upper);
  }
  return picked;
}

std::vector<double> RestrictedModel::outwards(std::span<const double> x) const {
  std::vector<double> all = fixed_;
  for (std::size_t i = 0; i < free_.size(); ++i) all[free_[i]] = x[i];
  all.insert(all.end(), x.begin() + static_cast<std::ptrdiff_t>(free_.size()), x.end());
  return all;
}

void RestrictedModel::pick_columns(std::span<const double> all, std::size_t rows,
                                   std::span<double> picked) const {
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < free_.size(); ++i) {
      picked[row * free_.size() + i] = all[row * fixed_.size() + free_[i]];
    }
  }
}

bool RestrictedModel::residuals(std::span<const double> x, std::span<double> r,
                                std::span<double> jacobian, std::span<double> local) const {
  const bool wants_derivatives = !jacobian.empty() || !local.empty();
  std::vector<double> whole(wants_derivatives ? r.size() * fixed_.size() : 0);
  // Without a free global variable the Jacobian is empty here, though not that of `inner`.
  if (!inner_.residuals(outwards(x), r, whole, local)) return false;
  if (!jacobian.empty()) pick_columns(whole, r.size(), jacobian);
  return true;
}

void RestrictedModel::constraints(std::span<const double> x, std::span<double> c,
                                  std::span<double> jacobian) const {
  std::vector<double> whole(jacobian.empty() ? 0 : c.size() * fixed_.size());
  inner_.constraints(outwards(x), c, whole);
  if (!jacobian.empty()) pick_columns(whole, c.size(), jacobian);
}

ModelRaster::ModelRaster(std::vector<RasterAxis> axes, std::vector<AxisVariable> variables,
                         std::vector<std::shared_ptr<const Model>> models,
                         ModelRasterOptions options)
    : axes_(std::move(axes)),
      variables_(std::move(variables)),
      models_(std::move(models)),
      options_(options) {}

RasterPoint ModelRaster::point(int form, std::vector<double> x) const {
  const Model& of = model(form);
  RasterPoint made;
  made.x = std::move(x);
  made.form = form;
  for (const AxisVariable& axis : variables_) {
    made.values.push_back(axis.to_value(made.x[static_cast<std::size_t>(axis.variable)]));
  }
  std::vector<double> r(static_cast<std::size_t>(of.residual_count()));
  if (of.residuals(made.x, r, {}, {})) made.objective = folded(of, r);
  made.violation = violation_at(of, made.x);
  return made;
}

void ModelRaster::place(const RasterNumbers& at, std::span<double> x) const {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    x[static_cast<std::size_t>(variables_[i].variable)] = variable_at(at, i);
  }
}

std::vector<RasterPoint> ModelRaster::relax(const RasterBox& box,
                                            std::span<const RasterPoint> from) const {
  std::vector<RasterPoint> minima;
  for (const RasterPoint& start : from) {
    auto found = relaxed(box, start);
    if (!found) continue;
    const auto same = [&](const RasterPoint& known) { return is_same(known, *found); };
    if (std::ranges::none_of(minima, same)) minima.push_back(*std::move(found));
  }
  return minima;
}

/// Empty where the start, brought into the box, has no value.
std::optional<RasterPoint> ModelRaster::relaxed(const RasterBox& box,
                                                const RasterPoint& from) const {
  const Model& whole = model(from.form);
  const auto globals = static_cast<std::size_t>(whole.global_count());
  std::vector<double> lower(globals), upper(globals);
  for (std::size_t i = 0; i < globals; ++i) {
    lower[i] = whole.variables()[i].lower;
    upper[i] = whole.variables()[i].upper;
  }
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto at = static_cast<std::size_t>(variables_[i].variable);
    lower[at] = variables_[i].of_value(axes_[i].values.at(box.first[i]));
    upper[at] = box.first[i] == box.last[i]
                    ? lower[at]
                    : variables_[i].of_value(axes_[i].values.at(box.last[i]));
  }
  const RestrictedModel model(whole, lower, upper);
  const std::vector<double> start = model.inwards(from.x);
  if (model.variables().empty()) {
    RasterPoint made = point(from.form, model.outwards(start));
    return std::isfinite(made.objective) ? std::optional(std::move(made)) : std::nullopt;
  }
  Options how{.tolerance = options_.tolerance,
              .feasibility = options_.feasibility,
              .max_iterations = options_.iterations};
  if (options_.deadline) how = until(*options_.deadline, how);
  const Solution solution = solve(options_.solver, model, start, how);
  if (solution.stop == Stop::no_value || !std::isfinite(solution.objective)) return std::nullopt;
  RasterPoint made;
  made.objective = solution.objective;
  made.violation = solution.violation;
  made.x = model.outwards(solution.x);
  made.form = from.form;
  for (const AxisVariable& axis : variables_) {
    made.values.push_back(axis.to_value(made.x[static_cast<std::size_t>(axis.variable)]));
  }
  return made;
}

bool ModelRaster::is_same(const RasterPoint& a, const RasterPoint& b) const {
  if (a.form != b.form) return false;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    if (std::abs(a.x[i] - b.x[i]) > options_.same * (1 + std::abs(a.x[i]))) return false;
  }
  return true;
}

}  // namespace cognate::synthesis
