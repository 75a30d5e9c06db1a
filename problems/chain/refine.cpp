#include "problems/chain/refine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/cosine_scan.hpp"
#include "problems/chain/model.hpp"
#include "synthesis/chain/drawn.hpp"

namespace cognate::problems {
namespace {

constexpr int kMostExchanges = 12;
/// From this exchange on the limit is tightened by what was exceeded: along a valley the extremes
/// move on with each solution.
constexpr int kTightened = 2;
constexpr double kHeld = 1e-10;  ///< violation of a cosine that is rounding
/// Beyond this a solution is left: it went where the chain cannot be assembled, from where nothing
/// leads back. What it says of the extremes is kept.
constexpr double kLost = 0.1;

CrankSpan limited_span(const ScaledChain& problem, const std::vector<double>& angles) {
  if (problem.over_turn) return {0, kTurn};
  if (!problem.timed()) {
    const auto [least, greatest] = std::ranges::minmax(angles);
    return {least, greatest};
  }
  const auto [least, greatest] = std::ranges::minmax(problem.crank_angles);
  return {angles[0] + least, angles[0] + greatest};
}

std::vector<TransmissionCheck> extremes_of(const ScaledChain& problem, RefinedChain& of) {
  return CosineScan(problem, of.design).extremes(limited_span(problem, of.angles), of.violation);
}

/// A design that is not refined.
RefinedChain as_it_is(const ScaledChain& problem, const synthesis::ChainDesign& design,
                      const std::vector<double>& angles, const TargetPlace& at) {
  const ChainPathModel model(problem, design, angles, at, {});
  std::vector<double> residuals(static_cast<std::size_t>(model.residual_count()));
  RefinedChain same{design, angles, at, std::numeric_limits<double>::infinity()};
  if (!model.residuals(model.start(), residuals, {}, {})) return same;
  same.objective = std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  return same;
}

}  // namespace

RefinedChain refine(const ScaledChain& problem, const synthesis::ChainDesign& design,
                    const std::vector<double>& angles, synthesis::Solver solver,
                    const synthesis::Options& options, const TargetPlace& at) {
  RefinedChain here{design, angles, at, std::numeric_limits<double>::infinity()};
  auto extremes = extremes_of(problem, here);
  const bool starts_within = here.violation <= kHeld;
  const bool are_fixed = problem.free.empty() && problem.over_turn;  // the transmission angles
  if (are_fixed) extremes.clear();
  std::vector<TransmissionCheck> checks;
  double margin = 0;
  for (int exchange = 0; exchange < kMostExchanges; ++exchange) {
    watch(problem, extremes, checks);
    const ChainPathModel model(problem, here.design, here.angles, here.at, checks, margin);
    const auto start = model.start();
    const synthesis::Solution solution = synthesis::solve(solver, model, start, options);
    here.evaluations += solution.evaluations;
    here.gradients += solution.gradients;
    here.iterations += solution.iterations;
    if (!std::isfinite(solution.objective) || solution.stop == synthesis::Stop::no_value) break;
    RefinedChain next = here;
    next.design = model.design(solution.x);
    synthesis::draw_anew(problem.lines, {1, 0}, next.design);
    next.angles = model.angles(solution.x);
    next.at = model.target_place(solution.x);
    next.objective = solution.objective;
    if (are_fixed) return next;
    extremes = extremes_of(problem, next);
    const bool is_lost = next.violation > kLost;
    if (!is_lost) here = std::move(next);
    if (!is_lost && here.violation <= kHeld) return here;
    if (!is_lost && exchange >= kTightened) margin += here.violation;
  }
  return starts_within ? as_it_is(problem, design, angles, at) : here;
}

}  // namespace cognate::problems
