#include "synthesis/robust/worst_case_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cognate::synthesis {
namespace {

/// Of one component the error with its sign, of more its length.
double error_at(const PerturbedModel::Sample& at, std::size_t station,
                const WorstCaseOptions& options) {
  const auto components = static_cast<std::size_t>(options.components);
  const double scale = options.scale.empty() ? 1 : options.scale[station];
  if (components == 1) return scale * at.r[station];
  double square = 0;
  for (std::size_t i = 0; i < components; ++i) {
    const double part = at.r[station * components + i];
    square += part * part;
  }
  return scale * std::sqrt(square);
}

}  // namespace

std::vector<SampledError> sampled_errors(const Model& nominal, const Perturbation& perturbation,
                                         const WorstCaseOptions& options,
                                         std::span<const double> x) {
  const PerturbedModel samples(nominal, perturbation, options.follow);
  const auto stations = static_cast<std::size_t>(nominal.residual_count() / options.components);
  std::vector<SampledError> all;
  all.reserve(perturbation.count() * stations);
  PerturbedModel::Sample& at = samples.memory();
  for (std::size_t k = 0; k < perturbation.count(); ++k) {
    const bool has_value = samples.evaluate(x, k, false, at);
    for (std::size_t station = 0; station < stations; ++station) {
      const double error = has_value ? std::abs(error_at(at, station, options))
                                     : std::numeric_limits<double>::infinity();
      all.push_back({k, station, error});
    }
  }
  return all;
}

WorstCaseModel::WorstCaseModel(const Model& nominal, const Perturbation& perturbation,
                               WorstCaseOptions options, std::vector<SampledError> chosen)
    : samples_(nominal, perturbation, options.follow),
      options_(std::move(options)),
      chosen_(std::move(chosen)) {}

/// By the theorem of the envelope local variables that follow take no part.
void WorstCaseModel::add_row(const PerturbedModel::Sample& at, std::size_t station, double residual,
                             std::span<double> row) const {
  const auto n = static_cast<std::size_t>(samples_.nominal().global_count());
  const auto components = static_cast<std::size_t>(options_.components);
  const double scale = options_.scale.empty() ? 1 : options_.scale[station];
  for (std::size_t i = 0; i < components; ++i) {
    const std::size_t from = station * components + i;
    // At no distance there is no slope.
    const double along = components == 1 ? scale
                         : residual > 0  ? scale * scale * at.r[from] / residual
                                         : 0;
    for (std::size_t k = 0; k < n; ++k) row[k] += along * at.jacobian[from * n + k] * at.slope[k];
  }
}

bool WorstCaseModel::residuals(std::span<const double> x, std::span<double> r,
                               std::span<double> jacobian, std::span<double> /*local*/) const {
  PerturbedModel::Sample& at = samples_.memory();
  std::ranges::fill(jacobian, 0.0);
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    const bool is_new = i == 0 || chosen_[i].sample != chosen_[i - 1].sample;
    if (is_new && !samples_.evaluate(x, chosen_[i].sample, !jacobian.empty(), at)) return false;
    r[i] = error_at(at, chosen_[i].station, options_);
    if (!jacobian.empty()) {
      add_row(at, chosen_[i].station, r[i], jacobian.subspan(i * x.size(), x.size()));
    }
  }
  return true;
}

}  // namespace cognate::synthesis
