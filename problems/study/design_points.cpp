#include "problems/study/design_points.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::problems {

double place_in(const Range& range, double u, bool logarithmic) {
  const double value = logarithmic ? range.min * std::pow(range.max / range.min, u)
                                   : range.min + u * (range.max - range.min);
  return std::clamp(u < 1 ? value : range.max, range.min, range.max);
}

DesignPoints::DesignPoints(const Study& study, std::uint64_t seed) : study_(&study) {
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    if (study.variables[i].range) sampled_.push_back(i);
  }
  if (sampled_.empty()) return;
  points_ = unit_points(study.sampling, sampled_.size(), study.samples, seed);
}

void DesignPoints::fill(std::int64_t first, std::span<double> values) {
  const std::size_t width = study_->variables.size();
  const std::int64_t samples = study_->samples;
  while (!values.empty()) {
    const std::int64_t sample = first % samples;
    const auto left = static_cast<std::int64_t>(values.size() / width);
    const std::int64_t count = std::min(left, samples - sample);
    unit_.resize(static_cast<std::size_t>(count) * sampled_.size());
    if (!unit_.empty()) points_(sample, unit_);
    for (std::int64_t i = 0; i < count; ++i) {
      const auto row = values.subspan(static_cast<std::size_t>(i) * width, width);
      fill_grid(first / samples, row);
      fill_samples(
          std::span(unit_).subspan(static_cast<std::size_t>(i) * sampled_.size(), sampled_.size()),
          row);
    }
    first += count;
    values = values.subspan(static_cast<std::size_t>(count) * width);
  }
}

void DesignPoints::fill_grid(std::int64_t point, std::span<double> values) const {
  for (std::size_t i = values.size(); i-- > 0;) {
    const StudyVariable& variable = study_->variables[i];
    if (variable.range) continue;
    const auto steps = static_cast<std::int64_t>(variable.values.size());
    values[i] = variable.values[static_cast<std::size_t>(point % steps)];
    point /= steps;
  }
}

void DesignPoints::fill_samples(std::span<const double> unit, std::span<double> values) const {
  for (std::size_t i = 0; i < sampled_.size(); ++i) {
    const StudyVariable& variable = study_->variables[sampled_[i]];
    values[sampled_[i]] = place_in(*variable.range, unit[i], variable.logarithmic);
  }
}

}  // namespace cognate::problems
