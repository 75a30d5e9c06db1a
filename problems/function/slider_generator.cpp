#include "problems/function/slider_generator.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/linkage/motion_within.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/error_peaks.hpp"

namespace cognate::problems {
namespace {

CrankRange motion_of(const SliderGenerator& generator, const Range& sweep) {
  return {generator.input_start + sweep.min, generator.input_start + sweep.max};
}

/// Inputs of `sweep`, increments from the start, where the mechanism may be at or near a dead
/// point: those at the ends and where the crank stands across the slide, if the transmission angle
/// is small there.
std::vector<double> critical_inputs(const SliderGenerator& generator, const Range& sweep) {
  const double start = generator.input_start;
  std::vector<double> inputs{sweep.min, sweep.max};
  const CrankRange motion = motion_of(generator, sweep);
  for (double k = std::ceil(motion.from / kPi - 0.5); (k + 0.5) * kPi < motion.to; ++k) {
    inputs.push_back((k + 0.5) * kPi - start);
  }
  std::erase_if(inputs, [&](double input) {
    const auto pressure = pressure_angle(generator.mechanism, start + input);
    return pressure && kRightAngle - std::abs(*pressure) > kNearDeadPoint;
  });
  return inputs;
}

}  // namespace

std::optional<double> displacement_error(const SliderGenerator& generator,
                                         const synthesis::AnglePair& wanted) {
  const auto reached = displacement(generator.mechanism, generator.input_start + wanted.input);
  if (!reached) return std::nullopt;
  return *reached - generator.output_start - wanted.output;
}

bool closes_over(const SliderGenerator& generator, const Range& sweep) {
  return motion_within(crank_ranges(generator.mechanism), motion_of(generator, sweep)).has_value();
}

TargetError displacement_error_over(const SliderGenerator& generator,
                                    const FunctionSamples& wanted) {
  TargetError error;
  const auto at = [&](const synthesis::AnglePair& pair) {
    return displacement_error(generator, pair).value_or(kInfinity);
  };
  for (const synthesis::AnglePair& pair : wanted.samples) {
    const double off = at(pair);
    error.sum_of_squares += off * off;
    error.max = std::max(error.max, std::abs(off));
  }
  error.rms = std::sqrt(error.sum_of_squares / static_cast<double>(wanted.samples.size()));
  if (!std::isfinite(error.sum_of_squares) || !closes_over(generator, wanted.sweep)) return error;
  for (const auto& pair : error_peaks(at, wanted, critical_inputs(generator, wanted.sweep))) {
    error.max = std::max(error.max, std::abs(at(pair)));
  }
  return error;
}

std::vector<Assembly> sides_of(const SliderGenerator& generator,
                               const std::vector<synthesis::PrecisionPoint>& points) {
  std::vector<Assembly> sides;
  for (const synthesis::PrecisionPoint& point : points) {
    const double pin = generator.mechanism.crank * std::cos(generator.input_start + point.input);
    const bool ahead = generator.output_start + point.output[0] >= pin;
    sides.push_back(ahead ? Assembly::open : Assembly::crossed);
  }
  return sides;
}

Metrics slider_metrics(const SliderGenerator& generator, const Range& sweep,
                       const std::vector<Assembly>& sides) {
  const SliderCrank& mechanism = generator.mechanism;
  Metrics metrics;
  metrics.change_point = is_change_point(mechanism);
  metrics.time_ratio = time_ratio(mechanism);
  const auto range = motion_within(crank_ranges(mechanism), motion_of(generator, sweep));
  const bool part = range && !crank_rotates(mechanism);
  const auto pressure = part ? pressure_angles(mechanism, *range) : pressure_angles(mechanism);
  if (pressure) {
    metrics.transmission_min = kRightAngle - pressure->max;
    metrics.transmission_max = kRightAngle - pressure->min;
    metrics.transmission_acute_min = std::max(0.0, kRightAngle - pressure->steepest);
  }
  if (!range) metrics.defects.push_back(Defect::circuit);
  if (std::ranges::adjacent_find(sides, std::ranges::not_equal_to{}) != sides.end()) {
    // The assemblies of a crank that turns fully are circuits, those of another are branches.
    const Defect defect = crank_rotates(mechanism) ? Defect::circuit : Defect::branch;
    if (std::ranges::count(metrics.defects, defect) == 0) metrics.defects.push_back(defect);
  }
  metrics.input_start = in_one_turn(generator.input_start);
  metrics.quantities.push_back({"class", std::string(name(mobility_class(mechanism)))});
  metrics.quantities.push_back(quantity(kSliderStartKey, generator.output_start));
  const auto driven = range ? stroke(mechanism, *range) : std::nullopt;
  if (driven) metrics.quantities.push_back({"stroke", *driven});
  if (const auto all = stroke(mechanism)) metrics.quantities.push_back({"circuit_stroke", *all});
  return metrics;
}

}  // namespace cognate::problems
