#include "problems/function_generator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/golden_section.hpp"

namespace cognate::problems {
namespace {

using synthesis::AnglePair;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Where `f` is greatest on [low, high], taken to have one peak there (golden section).
template <class F>
double peak(const F& f, double low, double high) {
  constexpr int kSteps = 30;
  return golden_section([&](double at) { return -f(at); }, low, high, kSteps).middle();
}

}  // namespace

double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

StructuralError::StructuralError(const FunctionGenerator& generator)
    : generator_(generator), closure_(generator.links) {}

std::optional<double> StructuralError::at(const AnglePair& wanted) const {
  const auto links = closure_.at(crank_direction(generator_.input_start + wanted.input),
                                 sign(generator_.assembly));
  if (!(links.discriminant >= 0) || !std::isfinite(links.rocker.x)) return std::nullopt;
  return wrapped(std::atan2(links.rocker.y, links.rocker.x) - generator_.output_start -
                 wanted.output);
}

double StructuralError::sum_of_squares(std::span<const AnglePair> wanted) const {
  double sum = 0;
  for (const AnglePair& pair : wanted) {
    const auto error = at(pair);
    if (!error) return kInfinite;
    sum += *error * *error;
  }
  return sum;
}

bool StructuralError::closes_over_domain(const FunctionSamples& wanted) const {
  return std::ranges::all_of(wanted.range,
                             [&](const AnglePair& pair) { return at(pair).has_value(); });
}

std::vector<AnglePair> StructuralError::peaks(const FunctionSamples& wanted) const {
  if (!closes_over_domain(wanted)) return {};
  std::vector<double> size;
  size.reserve(wanted.range.size());
  for (const AnglePair& pair : wanted.range) size.push_back(std::abs(*at(pair)));
  const auto size_at = [&](double share) { return std::abs(at(wanted.at(share)).value_or(0)); };
  const double step = 1.0 / kRangeSteps;
  std::vector<AnglePair> result;
  for (std::size_t i = 0; i < size.size(); ++i) {
    const bool first = i == 0, last = i + 1 == size.size();
    if (size[i] < 0.5 * std::ranges::max(size)) continue;
    if ((!first && size[i] < size[i - 1]) || (!last && size[i] < size[i + 1])) continue;
    const double share = static_cast<double>(i) * step;
    result.push_back(first || last ? wanted.range[i]
                                   : wanted.at(peak(size_at, share - step, share + step)));
  }
  return result;
}

TargetError StructuralError::over(const FunctionSamples& wanted) const {
  TargetError result{kInfinite, kInfinite, kInfinite};
  const double sum = sum_of_squares(wanted.samples);
  if (!std::isfinite(sum)) return result;
  result = {sum, 0, 0};
  result.rms = std::sqrt(sum / static_cast<double>(wanted.samples.size()));
  const auto peak_pairs = peaks(wanted);
  for (const auto& pairs : {std::span(wanted.samples), std::span(peak_pairs)}) {
    for (const AnglePair& pair : pairs) {
      result.max = std::max(result.max, std::abs(at(pair).value_or(0)));
    }
  }
  return result;
}

FourBar four_bar(const FunctionGenerator& generator) {
  FourBar linkage;
  linkage.pivot_d = {generator.links.frame, 0};
  linkage.crank = generator.links.crank;
  linkage.coupler = generator.links.coupler;
  linkage.rocker = generator.links.rocker;
  linkage.assembly = generator.assembly;
  return linkage;
}

std::optional<double> best_output_start(const FunctionGenerator& generator,
                                        std::span<const AnglePair> wanted) {
  const Closure<double> closure(generator.links);
  Vec2d mean;
  for (const AnglePair& pair : wanted) {
    const auto links =
        closure.at(crank_direction(generator.input_start + pair.input), sign(generator.assembly));
    if (!(links.discriminant >= 0) || !std::isfinite(links.rocker.x)) return std::nullopt;
    mean = mean + links.rocker * Vec2d{std::cos(pair.output), -std::sin(pair.output)};
  }
  return std::atan2(mean.y, mean.x);
}

}  // namespace cognate::problems
