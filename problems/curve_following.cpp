#include "problems/curve_following.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "analysis/motion.hpp"

namespace cognate::problems {
namespace {

/// Positions of the crank at which coupler curves are looked at.
constexpr int kPositions = 720;
/// A coupler curve leaves the target where it is so many times as far off as the samples are, and
/// so much of the target's length.
constexpr double kTimesTheError = 3, kShareOfLength = 2e-3;

/// The crank turns fully, so that it closes at every position; where rounding denies it at a change
/// point its neighbours tell as much.
double deviation(const ClosedCurve& curve, const Design& design) {
  const Motion motion(four_bar(design));
  const CurvePlacement placement = design.placement.value_or(CurvePlacement{});
  double greatest = 0;
  for (int k = 0; k < kPositions; ++k) {
    const auto pose = motion.at(2 * std::numbers::pi * k / kPositions);
    if (!pose || !pose->coupler_point) continue;
    greatest = std::max(greatest, curve.distance(placement.point_back(*pose->coupler_point)));
  }
  return greatest;
}

}  // namespace

void tell_following(const PathProblem& problem, Result& result) {
  if (!problem.curve) return;
  const ClosedCurve& curve = problem.curve->curve;
  result.facts.push_back({"target_length", curve.length()});
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    Design& design = result.designs[i];
    const double greatest = deviation(curve, design);
    design.metrics.facts.push_back({"curve_deviation_max", greatest});
    if (greatest <= kTimesTheError * design.error.max ||
        greatest <= kShareOfLength * curve.length()) {
      continue;
    }
    result.notes.push_back(fmt::format(
        "The coupler curve of design {} leaves the target by up to {:.4g} between samples that it "
        "meets within {:.4g}; more target.samples may keep it nearer.",
        i + 1, greatest, design.error.max));
  }
}

}  // namespace cognate::problems
