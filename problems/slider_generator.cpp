#include "problems/slider_generator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "analysis/angle.hpp"
#include "analysis/slider_crank_mobility.hpp"

namespace cognate::problems {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kRightAngle = std::numbers::pi / 2;

/// How far beyond a dead point an angle may lie by rounding, as in `find_defects`.
constexpr double kAngleTolerance = 1e-7;

/// The range of the crank that holds the whole sweep, turned so that it does; empty where none.
std::optional<CrankRange> range_with(const SliderGenerator& generator, const Range& sweep) {
  if (crank_rotates(generator.mechanism)) return CrankRange{0, 2 * std::numbers::pi};
  const double from = generator.input_start + sweep.min, to = generator.input_start + sweep.max;
  for (const CrankRange& range : crank_ranges(generator.mechanism)) {
    const double middle = 0.5 * (range.from + range.to);
    const double shift = std::remainder(0.5 * (from + to) - middle, 2 * std::numbers::pi) -
                         (0.5 * (from + to) - middle);
    const CrankRange own{std::clamp(from + shift, range.from, range.to),
                         std::clamp(to + shift, range.from, range.to)};
    const bool inside =
        from + shift >= range.from - kAngleTolerance && to + shift <= range.to + kAngleTolerance;
    if (inside) return own;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> displacement_error(const SliderGenerator& generator,
                                         const synthesis::AnglePair& wanted) {
  const auto reached = displacement(generator.mechanism, generator.input_start + wanted.input);
  if (!reached) return std::nullopt;
  return *reached - generator.output_start - wanted.output;
}

TargetError displacement_error_over(const SliderGenerator& generator,
                                    const std::vector<synthesis::AnglePair>& wanted) {
  TargetError error;
  for (const synthesis::AnglePair& pair : wanted) {
    const double off = displacement_error(generator, pair).value_or(kInfinite);
    error.sum_of_squares += off * off;
    error.max = std::max(error.max, std::abs(off));
  }
  error.rms = std::sqrt(error.sum_of_squares / static_cast<double>(wanted.size()));
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
  const auto range = range_with(generator, sweep);
  const auto pressure = range ? pressure_angles(mechanism, *range) : pressure_angles(mechanism);
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
  metrics.facts.push_back({"class", std::string(name(mobility_class(mechanism)))});
  metrics.facts.push_back({"output_start", generator.output_start});
  if (const auto length = stroke(mechanism)) metrics.facts.push_back({"stroke", *length});
  return metrics;
}

}  // namespace cognate::problems
