#include "problems/path/deviation_between_samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/curve_following.hpp"

namespace cognate::problems {
namespace {

/// Fewer positions than a finished design is judged by, and a wider allowance: the outline is that
/// of few samples.
constexpr int kPositions = 120;
constexpr double kTimesStrayed = 3, kShareStrayed = 0.02;

/// Whether the angles go round once, in either sense.
bool is_one_turn(std::span<const double> angles) {
  double forward = 0, backward = 0;
  for (std::size_t j = 0; j < angles.size(); ++j) {
    const double step = angles[(j + 1) % angles.size()] - angles[j];
    const double ahead = step - kTurn * std::floor(step / kTurn);
    forward += ahead;
    backward += kTurn - ahead;
  }
  return std::min(forward, backward) < 1.5 * kTurn;
}

}  // namespace

DeviationBetweenSamples::DeviationBetweenSamples(const PathProblem& searched) : problem_(searched) {
  if (!searched.constraints.no_extra_loop) return;
  std::vector<Vec2d> points = searched.points;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  outline_ = ClosedCurve(std::move(points));
}

bool DeviationBetweenSamples::strays(const FourBar& linkage,
                                     std::span<const double> crank_angles) const {
  const Constraints& constraints = problem_.constraints;
  if (!constraints.full_turn) return false;
  if (constraints.no_order_defect && !is_one_turn(crank_angles)) return true;
  if (!outline_) return false;
  const double error = path_error(linkage, problem_.points, crank_angles).max;
  const double most = std::max(kTimesStrayed * error, kShareStrayed * outline_->length());
  return curve_deviation(*outline_, linkage, {}, kPositions) > most;
}

}  // namespace cognate::problems
