#include "problems/tolerance/sampled.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "analysis/tolerance/sampling.hpp"
#include "problems/tolerance/draws.hpp"

namespace cognate::problems {
namespace {

constexpr double kShares[] = {0.5, 0.9, 0.95, 0.99, 0.999};
constexpr std::size_t kBins = 40;

/// What is sampled of the quantities, all of them.
std::vector<JudgedResponse> judged_responses(const TolerancedMechanism& toleranced,
                                             const ToleranceQuestion& question) {
  std::vector<JudgedResponse> judged;
  ChangedMechanism<double> nominal(toleranced.mechanism.nominal());
  for (const ToleranceQuantity& quantity : question.quantities) {
    JudgedResponse& one = judged.emplace_back();
    one.response = quantity.response;
    one.normal = quantity.normal;
    one.offset.assign(question.stations.size(), 0);
    for (std::size_t s = 0; s < question.stations.size(); ++s) {
      nominal.move_to(question.stations[s]);
      const Vec2d value = nominal.value(quantity.response);
      one.reference.push_back(quantity.target.empty() ? value : quantity.target[s]);
      if (!quantity.offset.empty()) one.offset[s] = quantity.offset[s];
      if (quantity.response.type == ResponseType::transmission) {
        // The farther from a right angle, the worse.
        one.offset[s] = std::atan2(value.y, value.x) - kPi / 2;
      }
    }
  }
  return judged;
}

/// The value that no more than so large a share of `samples` exceed, of which those that are not
/// among the sorted `values` do; not a number where these are too many.
double quantile(const std::vector<double>& values, double share, std::size_t samples) {
  const double place = std::ceil(share * static_cast<double>(samples));
  const auto index = static_cast<std::size_t>(std::max(place, 1.0)) - 1;
  return index < values.size() ? values[index] : std::numeric_limits<double>::quiet_NaN();
}

void add_histogram(const std::vector<double>& sorted, ToleranceFigures& figures) {
  const double least = sorted.front(), greatest = quantile(sorted, 0.9999, sorted.size());
  const double width = (greatest - least) / static_cast<double>(kBins);
  if (!(width > 0)) return;
  figures.histogram.assign(kBins, 0);
  for (std::size_t k = 0; k <= kBins; ++k) {
    figures.histogram_edges.push_back(least + width * static_cast<double>(k));
  }
  for (const double value : sorted) {
    const auto bin = static_cast<std::size_t>((value - least) / width);
    if (bin < kBins) ++figures.histogram[bin];
  }
}

}  // namespace

void note_samples(ToleranceResult& result) {
  if (result.samples == 0) return;
  const auto count = static_cast<double>(result.samples);
  const auto beyond = std::ranges::find_if(
      kShares, [&](double share) { return std::ceil(share * count) == count; });
  if (beyond != std::end(kShares)) {
    result.notes.push_back(fmt::format(
        "{} {} too few for the quantile of {} %: it is the greatest of them", result.samples,
        result.samples == 1 ? "sample is" : "samples are", 100 * *beyond));
  }
  if (result.assembled == result.samples) return;
  const double open = static_cast<double>(result.samples - result.assembled) / count;
  result.notes.push_back(
      fmt::format("{:.3g} % of the samples cannot be assembled at every position", 100 * open));
}

void set_extremes_of_samples(ResponseType type, std::vector<double> extremes, std::size_t samples,
                             ToleranceFigures& figures) {
  if (extremes.empty()) return;
  const bool acute = type == ResponseType::transmission;
  if (acute) {
    for (double& extreme : extremes) extreme = kPi / 2 - extreme;
  }
  figures.mean_extreme =
      std::accumulate(extremes.begin(), extremes.end(), 0.0) / static_cast<double>(extremes.size());
  std::ranges::sort(extremes);
  add_histogram(extremes, figures);
  if (acute) std::ranges::reverse(extremes);
  for (const double share : kShares) {
    figures.quantiles.push_back({share, quantile(extremes, share, samples)});
  }
}

void set_yield(const Tolerances& tolerances, bool angle, const std::vector<double>& extremes,
               ToleranceResult& result) {
  if (!tolerances.max_error || result.samples == 0) return;
  const double limit = *tolerances.max_error * (angle ? kPi / 180 : 1);
  const auto good = std::ranges::count_if(extremes, [&](double error) { return error <= limit; });
  const auto count = static_cast<double>(result.samples);
  const double yield = static_cast<double>(good) / count;
  result.yield = yield;
  result.yield_standard_error = std::sqrt(yield * (1 - yield) / count);
}

void add_samples(const TolerancedMechanism& toleranced, const Tolerances& tolerances,
                 const ToleranceQuestion& question, const ToleranceRun& run,
                 ToleranceResult& result) {
  if (tolerances.samples == 0 || toleranced.dimensions.empty()) return;
  const auto judged = judged_responses(toleranced, question);
  SamplingOptions options{.samples = static_cast<std::size_t>(tolerances.samples),
                          .draw =
                              [&](std::size_t first, std::size_t count, std::span<double> changes) {
                                draw_changes(toleranced.dimensions, tolerances.distribution,
                                             run.seed, first, count, changes);
                                reject_lost_lengths(toleranced.dimensions, count, changes);
                              },
                          .threads = run.threads,
                          .stop = run.stop};
  SampleStatistics drawn = sample(toleranced.mechanism, judged, question.stations, options);
  result.samples = drawn.samples;
  result.assembled = drawn.assembled;
  if (drawn.samples < options.samples) {
    result.notes.push_back(
        fmt::format("stopped after {} of {} samples", drawn.samples, options.samples));
  }
  note_samples(result);
  if (result.quantities.empty()) return;
  for (std::size_t q = 0; q < question.quantities.size(); ++q) {
    ToleranceFigures& figures = result.quantities[q];
    for (std::size_t s = 0; s < figures.positions.size(); ++s) {
      figures.positions[s].mean = drawn.responses[q].stations[s].mean;
      figures.positions[s].sigma = drawn.responses[q].stations[s].standard_deviation;
    }
    if (question.quantities[q].judged) {
      set_yield(tolerances, figures.angle, drawn.responses[q].extremes, result);
    }
    set_extremes_of_samples(question.quantities[q].response.type,
                            std::move(drawn.responses[q].extremes), drawn.samples, figures);
  }
}

}  // namespace cognate::problems
