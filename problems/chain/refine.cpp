#include "problems/chain/refine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/cosine_scan.hpp"
#include "problems/chain/model.hpp"

namespace cognate::problems {
namespace {

constexpr int kMostExchanges = 12;
/// From this exchange on the limit is tightened by what was exceeded: along a valley the extremes
/// move on with each solution.
constexpr int kTightened = 2;
constexpr double kHeld = 1e-10;  ///< violation of a cosine that is rounding

CrankSpan limited_span(const ScaledChain& problem, const std::vector<double>& angles) {
  if (problem.over_turn) return {0, kTurn};
  if (!problem.timed()) {
    const auto [least, greatest] = std::ranges::minmax(angles);
    return {least, greatest};
  }
  const auto [least, greatest] = std::ranges::minmax(problem.crank_angles);
  return {angles[0] + least, angles[0] + greatest};
}

}  // namespace

RefinedChain refine(const ScaledChain& problem, const synthesis::ChainDesign& design,
                    const std::vector<double>& angles, synthesis::Solver solver,
                    const synthesis::Options& options) {
  RefinedChain here{design, angles, std::numeric_limits<double>::infinity()};
  std::vector<TransmissionCheck> checks;
  double margin = 0;
  for (int exchange = 0; exchange < kMostExchanges; ++exchange) {
    const auto fresh = CosineScan(problem, here.design)
                           .extremes(limited_span(problem, here.angles), here.violation);
    if (exchange > 0 && here.violation <= kHeld) break;
    if (exchange >= kTightened) margin += here.violation;
    checks.insert(checks.end(), fresh.begin(), fresh.end());
    const ChainPathModel model(problem, here.design, here.angles, checks, margin);
    const auto start = model.start();
    const synthesis::Solution solution = synthesis::solve(solver, model, start, options);
    here.evaluations += solution.evaluations;
    here.gradients += solution.gradients;
    here.iterations += solution.iterations;
    if (!std::isfinite(solution.objective) || solution.stop == synthesis::Stop::no_value) break;
    here.design = model.design(solution.x);
    here.angles = model.angles(solution.x);
    here.objective = solution.objective;
  }
  CosineScan(problem, here.design).extremes(limited_span(problem, here.angles), here.violation);
  return here;
}

}  // namespace cognate::problems
