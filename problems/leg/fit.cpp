#include "problems/leg/fit.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/leg/checks.hpp"
#include "problems/leg/starts.hpp"
#include "synthesis/chain/drawn.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

/// Radians or shares of the stance: of two places so close one is watched.
constexpr double kClose = 1e-3;

/// Adds what was watched before to the extremes of now, but for what is close to one of them.
void watch(const LegSpace& space, const LegChecks& before, LegChecks& now) {
  const auto add = [](auto& all, const auto& more, const auto& distance) {
    const std::size_t count = all.size();
    for (const auto& one : more) {
      const auto is_close = [&](const auto& known) { return distance(known, one) < kClose; };
      if (std::none_of(all.begin(), all.begin() + std::ptrdiff_t(count), is_close)) {
        all.push_back(one);
      }
    }
  };
  const auto apart = [](double a, double b) { return std::abs(a - b); };
  add(now.transmission, before.transmission,
      [](const TransmissionCheck& a, const TransmissionCheck& b) {
        return a.joint == b.joint ? std::abs(a.crank - b.crank) : kNoFit;
      });
  problems::watch(space, {}, now.transmission);
  add(now.swing, before.swing, apart);
  add(now.slow, before.slow, apart);
  add(now.fast, before.fast, apart);
}

/// Half the band within which the longest stance is sought.
double most_band(const LegSpace& space) {
  return 0.5 * space.problem->target.flatness_max.value_or(1) - kLegMargin;
}

/// Minimax fits from `start`, constraints asked anew where they are extreme, until none is violated
/// between and the objective stays: the best of these, or the last where each violates.
FittedLeg fitted_leg(const LegSpace& space, const LegDesign& start, LegObjective objective,
                     const FitDepth& depth, const synthesis::WorkCounter& work) {
  constexpr double kStays = 1e-3;  // relative
  FittedLeg here{start}, best;
  double violation = 0, unit = 0.01;
  const bool finds_span = objective == LegObjective::duty;
  const double most = most_band(space);
  LegChecks checks = leg_checks(space, start, violation);
  checks.band = most;
  for (int exchange = 0; exchange < depth.exchanges; ++exchange) {
    const LegModel model(space, here.design, checks, depth.nodes, finds_span ? 1 : unit, objective);
    const auto x = model.start();
    const synthesis::Solution solution =
        synthesis::solve(synthesis::Solver::slsqp, model, x, depth.options);
    work.count(solution);
    if (solution.stop == synthesis::Stop::no_value || !std::isfinite(solution.objective)) break;
    here.design = model.design(solution.x);
    synthesis::draw_anew(space.lines, {1, 0}, here.design.chain);
    here.objective = solution.objective * (finds_span ? 1 : unit);
    if (!finds_span) unit = std::max(here.objective, 1e-9);
    LegChecks fresh = leg_checks(space, here.design, violation);
    here.violation = std::max(violation, solution.violation);
    if (finds_span) {
      const double half = half_band(space, here.design);
      here.violation = std::max(here.violation, half - most);
      // What the foot leaves the band by between the nodes, the band is narrower at these.
      fresh.band = most - std::clamp(half - checks.band, 0.0, 0.1 * most);
    }
    if (here.violation <= kFeasibleLeg) {
      const bool stays = here.objective > (1 - kStays) * best.objective;
      if (here.objective < best.objective) best = here;
      if (stays) break;
    }
    watch(space, checks, fresh);
    checks = std::move(fresh);
  }
  return std::isfinite(best.objective) ? best : here;
}

bool is_within_bounds(const LegSpace& space, const synthesis::ChainDesign& chain) {
  return std::ranges::all_of(space.free, [&](int parameter) {
    const auto i = static_cast<std::size_t>(parameter);
    const double value = chain.parameters[i], slack = kFeasibleLeg * std::abs(value);
    return value >= space.lower[i] - slack && value <= space.upper[i] + slack;
  });
}

}  // namespace

FittedLeg fitted_leg(const LegSpace& space, const LegDesign& start, const FitDepth& depth,
                     const synthesis::WorkCounter& work) {
  const LegObjective objective = space.problem->target.objective;
  if (objective == LegObjective::flatness) {
    return fitted_leg(space, start, objective, depth, work);
  }
  FittedLeg flat{start};
  if (half_band(space, start) > most_band(space)) {
    flat = fitted_leg(space, start, LegObjective::flatness, depth, work);
    flat.objective += 1;
    if (!(half_band(space, flat.design) <= most_band(space))) return flat;
  }
  FittedLeg longest = fitted_leg(space, flat.design, objective, depth, work);
  return longest.violation <= kNearlyFeasibleLeg ? longest : flat;
}

FittedLeg measured(const LegSpace& space, const synthesis::ChainDesign& chain, double duty) {
  const auto leg = with_stance(space, chain, duty);
  if (!leg || !is_within_bounds(space, leg->chain)) return {};
  FittedLeg one{*leg};
  const double half = half_band(space, *leg);
  const bool finds_span = space.problem->target.objective == LegObjective::duty;
  one.violation = 0;
  leg_checks(space, *leg, one.violation);
  if (finds_span) one.violation = std::max(one.violation, half - most_band(space));
  one.objective = finds_span ? 1 - duty : half;
  one.is_feasible = one.violation <= kFeasibleLeg && one.objective < 1;
  return one;
}

FittedLeg judged(const LegSpace& space, FittedLeg fit) {
  const FittedLeg same = measured(space, fit.design.chain, fit.design.span / kTurn);
  fit.is_feasible = fit.violation <= kFeasibleLeg && fit.objective < 1 && same.is_feasible;
  return fit;
}

bool is_better(const FittedLeg& other, const FittedLeg& fit) {
  return other.is_feasible && !(fit.is_feasible && fit.objective <= other.objective);
}

FittedLeg lengthened(const LegSpace& space, const FittedLeg& leg) {
  constexpr double kStep = 0.005, kClosest = 1e-5;
  double least = leg.design.span / kTurn, beyond = kMostDuty;
  FittedLeg longest = leg;
  const auto reaches = [&](double duty) {
    const FittedLeg one = measured(space, leg.design.chain, duty);
    if (!one.is_feasible) return false;
    longest = one;
    return true;
  };
  // From the greatest on: a part of the path that rises may be followed by one that does not.
  for (double duty = kMostDuty; duty > least; duty -= kStep) {
    if (reaches(duty)) {
      least = duty;
      break;
    }
    beyond = duty;
  }
  while (beyond - least > kClosest) {
    const double middle = 0.5 * (least + beyond);
    (reaches(middle) ? least : beyond) = middle;
  }
  return longest;
}

}  // namespace cognate::problems
