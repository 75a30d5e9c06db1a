#include "problems/path/narrowed_limits.hpp"

#include <algorithm>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr double kMostExceeded = 3 * kDegree;
/// Of what is exceeded, by how much limits are narrowed.
constexpr double kNarrowing = 1.5;

std::optional<Range> narrowed_limits(const Range& limits, const Design& design) {
  const bool is_alone = std::ranges::all_of(design.constraints, [](const ConstraintCheck& check) {
    return check.satisfied || check.name == "transmission_angle_deg";
  });
  const double below = std::max(0.0, limits.min - design.metrics.transmission_min);
  const double above = std::max(0.0, design.metrics.transmission_max - limits.max);
  if (!is_alone || !(std::max(below, above) <= kMostExceeded)) return std::nullopt;
  const Range narrowed{limits.min + kNarrowing * below, limits.max - kNarrowing * above};
  return narrowed.min < narrowed.max ? std::optional(narrowed) : std::nullopt;
}

}  // namespace

std::optional<NarrowedPath> narrowed(const PathProblem& scaled, const PathScale& scale,
                                     const Design& design, const Run& run) {
  const auto& limits = scaled.constraints.transmission_angle;
  const auto within = limits ? narrowed_limits(*limits, design) : std::nullopt;
  if (!within) return std::nullopt;
  NarrowedPath narrowed{scaled, silent(run)};
  narrowed.problem.constraints.transmission_angle = within;
  narrowed.problem.solve.starts = 0;
  narrowed.run.known = {design};
  narrowed.run.known.front().mechanism.description = scale.into(four_bar(design));
  return narrowed;
}

}  // namespace cognate::problems
