#include "problems/function/notes.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion_within.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/function/scatter.hpp"
#include "problems/function/target/jumps.hpp"

namespace cognate::problems {
namespace {

constexpr int kIntervals = 1000;  ///< in which a function is searched for jumps

/// min(μ, π − μ) at a crank angle.
double acute_transmission(const Design& design, double angle) {
  if (const auto* slider = std::get_if<SliderCrank>(&design.mechanism.description)) {
    return kRightAngle - std::abs(pressure_angle(*slider, angle).value_or(kRightAngle));
  }
  return transmission_angles(lengths(four_bar(design)), {angle, angle}).acute_min;
}

/// The first input of the motion, from its start, at a dead point: at its ends, or where the
/// transmission angle is extreme. Empty where there is none, or no such motion.
std::optional<double> dead_input(const Design& design, const Range& sweep) {
  const bool slider = std::holds_alternative<SliderCrank>(design.mechanism.description);
  const auto ranges = slider ? crank_ranges(std::get<SliderCrank>(design.mechanism.description))
                             : crank_ranges(lengths(four_bar(design)));
  const double start = *design.metrics.input_start, first = slider ? kRightAngle : 0;
  const double from = start + sweep.min, to = start + sweep.max;
  if (!motion_within(ranges, {from, to})) return std::nullopt;
  std::vector<double> angles{from};
  for (double k = std::ceil((from - first) / kPi); first + k * kPi < to; ++k) {
    angles.push_back(first + k * kPi);
  }
  angles.push_back(to);
  for (const double angle : angles) {
    if (acute_transmission(design, angle) <= kDeadTransmission) return angle - start;
  }
  return std::nullopt;
}

/// On a table or list of pairs that scatters.
std::optional<std::string> scatter_note(const FunctionProblem& problem) {
  const auto* function = std::get_if<FunctionOfX>(&problem.target);
  const auto share = function ? scatter_share(function->table)
                              : scatter_share(std::get<AnglePairs>(problem.target));
  if (!share) return std::nullopt;
  const std::string scatter = fmt::format(
      "The target scatters about a smooth curve by {:.2g} % of its range, as measured values do",
      100 * *share);
  if (problem.objective == FunctionObjective::least_squares) {
    return scatter + ": errors of that size are its own, and the design follows the curve.";
  }
  return scatter +
         ": objective = \"least-squares\" averages it, this objective follows single values.";
}

}  // namespace

void note_motions(const FunctionProblem& problem, const FunctionSamples& wanted, Result& result) {
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const auto input = dead_input(result.designs[i], wanted.sweep);
    if (!input) continue;
    result.notes.push_back(fmt::format(
        "Design {}: the transmission angle is 0 or 180 degrees at an input of {:.4g} degrees, a "
        "dead point or change point within the motion: the output may lock there or go on in the "
        "other assembly.",
        i + 1, degrees(*input)));
  }
  if (const auto note = scatter_note(problem)) result.notes.push_back(*note);
  const auto* function = std::get_if<FunctionOfX>(&problem.target);
  if (!function || function->text.empty()) return;
  const auto jumps = reading::find_jumps(function->y, function->domain, kIntervals);
  if (jumps.empty()) return;
  result.notes.push_back(
      fmt::format("The function jumps at x = {:.6g}: no linkage follows it there, and the maximum "
                  "error is at least half of the jump.",
                  jumps.front()));
}

}  // namespace cognate::problems
