#include "problems/function/generator.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion_within.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/error_peaks.hpp"

namespace cognate::problems {
namespace {

using synthesis::AnglePair;

/// Inputs of `sweep`, increments from the start, where the linkage may be at or near a dead point:
/// those at the ends and where crank and frame are collinear, if the transmission angle is near 0
/// or 180° there.
std::vector<double> critical_inputs(const FunctionGenerator& generator, const Range& sweep) {
  const double start = generator.input_start;
  std::vector<double> inputs{sweep.min, sweep.max};
  for (double k = std::ceil((start + sweep.min) / kPi); k * kPi < start + sweep.max; ++k) {
    inputs.push_back(k * kPi - start);
  }
  std::erase_if(inputs, [&](double input) {
    const CrankRange there{start + input, start + input};
    return transmission_angles(generator.links, there).acute_min > kNearDeadPoint;
  });
  return inputs;
}

}  // namespace

double wrapped(double angle) {
  return std::remainder(angle, kTurn);
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
    if (!error) return kInfinity;
    sum += *error * *error;
  }
  return sum;
}

bool StructuralError::closes_over(const Range& sweep) const {
  return motion_within(crank_ranges(generator_.links),
                       {generator_.input_start + sweep.min, generator_.input_start + sweep.max})
      .has_value();
}

std::vector<AnglePair> StructuralError::peaks(const FunctionSamples& wanted) const {
  if (wanted.range.empty() || !closes_over(wanted.sweep)) return {};
  const auto error = [&](const AnglePair& pair) { return at(pair).value_or(0); };
  return error_peaks(error, wanted, critical_inputs(generator_, wanted.sweep));
}

TargetError StructuralError::over(const FunctionSamples& wanted) const {
  TargetError result{kInfinity, kInfinity, kInfinity};
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
