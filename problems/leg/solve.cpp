/// Legs from problem to designs: search, conversion to the file's units, verification.

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/chain/found_designs.hpp"
#include "problems/chain/front/front.hpp"
#include "problems/leg/given.hpp"
#include "problems/leg/search.hpp"
#include "problems/leg/starts.hpp"
#include "problems/leg/verify.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/gait_quantities.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/search/solver_origin.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {
namespace {

/// A leg in the file's unit, its stride met exactly where the file gives and bounds nothing.
NamedMechanism mechanism_of(const LegMinimum& found) {
  const LegSpace& space = *found.space;
  synthesis::ChainDesign chain = found.design.chain;
  const double duty = found.design.span / kTurn;
  if (const auto own = space.is_movable ? gait_of(space, chain, duty) : std::nullopt) {
    for (double& parameter : chain.parameters) parameter /= own->stride;
  }
  return named(*space.topology, space.scale.out_of(space.chain, chain));
}

/// Those that meet every limit, the best first; the others only where there are no such.
std::vector<Design> designs_of_legs(const LegProblem& problem,
                                    const std::vector<LegMinimum>& found) {
  std::vector<Design> designs;
  for (const LegMinimum& one : found) {
    Design design =
        verified(problem, *one.space->topology, mechanism_of(one), one.design.span / kTurn);
    if (!std::isfinite(design.error.max)) continue;
    design.origin = search_origin({synthesis::Solver::slsqp});
    designs.push_back(std::move(design));
  }
  return feasible_or_all(std::move(designs), problem.solve.designs);
}

/// The leg that the file gives.
Result take_given(const LegProblem& problem, const Deadline& deadline) {
  Result result;
  if (auto design = given_design(problem)) result.designs.push_back(*std::move(design));
  result.status = status_of(result.designs, deadline);
  return result;
}

/// The legs that the search finds; `closes`: whether one has been assembled over the whole turn.
Result find_legs(const LegProblem& problem, const std::vector<LegSpace>& spaces, const Run& run,
                 const Deadline& deadline, bool& closes) {
  Result result;
  const LegSearchResult found = search_legs(spaces, problem.solve, run, deadline, result.work);
  closes = closes || found.closes;
  result.quantities = quantities(found.statistics);
  result.designs = designs_of_legs(problem, found.designs);
  result.status = status_of(result.designs, deadline);
  return result;
}

std::vector<LegSpace> spaces_of(const LegProblem& problem) {
  std::vector<LegSpace> spaces;
  if (is_given(problem)) return spaces;
  for (const Topology& topology : problem.topologies) spaces.emplace_back(problem, topology);
  return spaces;
}

/// The error is the flatness, or where the duty factor is the objective the share of the turn in
/// which the foot swings.
ChainFrontProblem front_of_leg(const LegProblem& problem, bool& closes) {
  const bool is_flat = problem.target.objective == LegObjective::flatness;
  const auto error = [is_flat](const Design& design) {
    const auto& quantities = design.metrics.quantities;
    return is_flat ? find_quantity(quantities, kFlatnessKey).value_or(kInfinity)
                   : 1 - find_quantity(quantities, kDutyKey).value_or(0);
  };
  const auto solve = [&](const ChainDemand& demand, const Run& run, const Deadline& end) {
    const LegProblem one = with_demand(problem, demand);
    return find_legs(one, spaces_of(one), run, end, closes);
  };
  return {*problem.against,
          demand_of(problem),
          kMetError,
          1,
          is_flat ? "flatness" : "swing_share",
          error,
          error,
          solve};
}

std::string nothing_found(const LegProblem& problem, bool closes) {
  if (is_given(problem)) {
    return "The leg given is not assembled over the whole turn; change its dimensions.";
  }
  if (!closes) {
    return "No start led to a leg that is assembled over the whole turn; change the dimensions "
           "given, or widen the bounds.";
  }
  return "No leg was found that is assembled over the whole turn within the limits; wider limits "
         "or "
         "more starts may help.";
}

/// The level of the foot in stance, from the middle of its band.
std::optional<ToleranceQuestion> leg_question(const LegProblem& problem, const Design& design) {
  constexpr int kSteps = 45;
  if (design.crank_angles.size() < 2) return std::nullopt;
  // All topologies that one word stands for have one name of the foot.
  const Topology& topology = problem.topologies.front();
  const auto& name = topology.lines[static_cast<std::size_t>(topology.trace)].name;
  std::vector<double> angles;
  const double from = design.crank_angles[0], way = design.crank_angles[1] - from;
  const double span = way > 0 ? way : way + kTurn;
  for (int i = 0; i <= kSteps; ++i) angles.push_back(from + span * i / kSteps);
  auto [question, kept] = question_at(design.mechanism, angles);
  const auto foot = point_response(design.mechanism, name);
  if (!foot || kept.size() != angles.size()) return std::nullopt;
  ToleranceQuantity level{.name = name, .response = *foot, .judged = true};
  for (const Vec2d& place : path_frame(design.mechanism, question, *foot).place) {
    level.offset.push_back(place.y);
    level.normal.push_back({0, 1});
  }
  const auto [low, high] = std::ranges::minmax(level.offset);
  for (double& offset : level.offset) offset -= 0.5 * (low + high);
  question.quantities.push_back(std::move(level));
  add_transmissions(design.mechanism, question);
  return std::move(question);
}

}  // namespace

Result solve(const LegProblem& given, const Run& run) {
  const auto valid = KindTraits<LegProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const LegProblem& problem = *valid;
  const Deadline deadline(run);
  const std::vector<LegSpace> spaces = spaces_of(problem);
  bool closes = false;
  const auto source = is_given(problem) ? DesignSource::exact : DesignSource::search;
  Result result = solve_in_layers(problem, run, source, [&](const LegProblem& one, const Run& own) {
    if (is_given(one)) return take_given(one, deadline);
    return one.against ? chain_front(front_of_leg(one, closes), own, deadline)
                       : find_legs(one, spaces, own, deadline, closes);
  });
  add_warnings(std::nullopt, problem.warnings, result);
  if (result.designs.empty()) {
    result.notes.push_back(nothing_found(problem, closes));
  }
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) { return leg_question(problem, design); }, result);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
