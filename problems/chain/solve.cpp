/// Path generation by chains from problem to designs: search, conversion to the file's units,
/// verification.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/numbers/parallel.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/chain/found_designs.hpp"
#include "problems/chain/front/front.hpp"
#include "problems/chain/given.hpp"
#include "problems/chain/minima_designs.hpp"
#include "problems/chain/problem.hpp"
#include "problems/chain/raster/search.hpp"
#include "problems/chain/robust.hpp"
#include "problems/chain/scaled.hpp"
#include "problems/chain/search.hpp"
#include "problems/chain/starts/known.hpp"
#include "problems/chain/starts/placed.hpp"
#include "problems/chain/verify.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/raster/report.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/search/objectives.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {
namespace {

/// The designs of the raster, from those that the search found without one.
void take_raster(const ChainPathProblem& problem, const TargetScale& scale,
                 const ScaledChain& scaled, const std::vector<ChainMinimum>& continuous,
                 const Run& run, const Deadline& deadline, Result& result) {
  const auto design_of = [&](const RasterChain& chain) {
    const ChainMinimum as_found{&scaled, chain.design, chain.angles, 0};
    Design design = verified(problem, *scaled.topology, named(*scaled.topology, chain.design),
                             angles_of_targets(as_found), chain.placement);
    design.origin = "raster";
    return design;
  };
  const auto accepts = [&](const RasterChain& chain) {
    const Design design = design_of(chain);
    return std::isfinite(design.error.sum_of_squares) && all_satisfied(design.constraints);
  };
  const auto found = search_chain_raster(problem, scaled, scale, continuous, accepts,
                                         on_values(run), deadline, result.work);
  result.designs.clear();
  for (const RasterChain& chain : found.designs) result.designs.push_back(design_of(chain));
  // The objective is the mean square.
  const auto error = [&](double objective) { return scale.size * std::sqrt(objective); };
  std::ranges::move(raster_quantities(found.search, error), std::back_inserter(result.quantities));
  result.notes = raster_notes(found.search, error);
}

void note_unknowns(const ChainPathProblem& problem, const std::vector<ScaledChain>& chains,
                   Result& result) {
  std::size_t unknowns = 0;
  for (const ScaledChain& chain : chains) unknowns = std::max(unknowns, chain.free.size());
  const bool timed = !problem.crank_angles.empty();
  const std::size_t equations = (timed ? 2 : 1) * problem.points.size();
  if (equations >= unknowns + (timed ? 1 : 0)) return;
  result.notes.push_back(
      "The target has fewer points than the chain has dimensions: infinitely many designs meet it "
      "exactly. Give more points to define the path between them.");
}

/// The target where the design has it.
std::vector<Vec2d> placed_points(const ChainPathProblem& problem, const Design& design) {
  std::vector<Vec2d> points = problem.points;
  const CurvePlacement placement = design.placement.value_or(CurvePlacement{});
  for (Vec2d& point : points) point = placement.point(point);
  return points;
}

/// Of a design the traced point of its topology.
void add_chain_tolerances(const ChainPathProblem& problem, const Run& run, Result& result) {
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) -> std::optional<ToleranceQuestion> {
        const auto name =
            find_quantity(design.metrics.quantities, QuantityKey<std::string>{"topology"});
        const auto topology =
            std::ranges::find(problem.topologies, name.value_or(""), &Topology::name);
        if (topology == problem.topologies.end()) return std::nullopt;
        return error_at_targets(
            design.mechanism, topology->lines[static_cast<std::size_t>(topology->trace)].name,
            design.crank_angles, placed_points(problem, design), !problem.crank_angles.empty());
      },
      result);
}

/// Minima of least error, and such with transmission angles far from those of dead points, which
/// mind their dimensions less. `narrowed` must outlive them.
std::vector<ChainMinimum> nominal_minima(const ChainPathProblem& problem,
                                         const std::vector<ScaledChain>& chains,
                                         std::vector<ScaledChain>& narrowed, const Run& run,
                                         const Deadline& deadline, Result& result) {
  Solve options = problem.solve;
  options.designs = std::max(options.designs, kMinima);
  const auto search = [&](const std::vector<ScaledChain>& spaces, const Run& part) {
    return search_chains(spaces, options, part, deadline, result.work);
  };
  ChainSearchResult nominal = search(chains, part_of(run, 0, kNominalDone));
  result.quantities = quantities(nominal.statistics);
  Constraints own;
  own.transmission_angle = problem.constraints.transmission_angle;
  if (const auto limits = with_good_transmission(own)) {
    ChainPathProblem other = problem;
    other.constraints.transmission_angle = *limits->transmission_angle;
    const TargetScale scale(problem.points);
    for (const ScaledChain& chain : chains) narrowed.emplace_back(other, *chain.topology, scale);
    std::ranges::move(search(narrowed, part_of(run, kNominalDone, kStartsDone)).designs,
                      std::back_inserter(nominal.designs));
  }
  return std::move(nominal.designs);
}

/// The nominal optimum and other minima, and from these the designs whose quantile is least.
Result find_robust_chains(const ChainPathProblem& problem, const std::vector<ScaledChain>& chains,
                          const Run& run, const Deadline& deadline) {
  const TargetScale scale(problem.points);
  Result result;
  run.enter(Phase::search, kStartsDone);
  std::vector<ScaledChain> narrowed;
  const auto minima = nominal_minima(problem, chains, narrowed, run, deadline, result);
  const auto verify = [&](const ChainMinimum& found) -> std::optional<Design> {
    const ScaledChain& space = *found.problem;
    Design design = verified(problem, *space.topology,
                             named(*space.topology, scale.out_of(space.chain, found.design)),
                             angles_of_targets(found));
    const bool is_met =
        std::isfinite(design.error.sum_of_squares) && all_satisfied(design.constraints);
    return is_met ? std::optional(std::move(design)) : std::nullopt;
  };
  RobustTask task = robust_chain_task(problem, scale, chains, minima, verify);
  task.error = [](const Design& design) { return design.error.rms; };
  add_robust(task, robust_designs(task, part_of(run, kStartsDone, 1), deadline), false, result);
  result.status = status_of(result.designs, deadline);
  return result;
}

/// The chain that the file gives.
Result take_given(const ChainPathProblem& problem, const Deadline& deadline) {
  Result result;
  if (auto design = given_design(problem)) result.designs.push_back(*std::move(design));
  result.status = status_of(result.designs, deadline);
  return result;
}

/// The designs of least error that the search finds, or those on the raster next to them.
Result find_least_error(const ChainPathProblem& problem, const std::vector<ScaledChain>& chains,
                        const Run& run, const Deadline& deadline) {
  const TargetScale scale(problem.points);
  const ChainPathProblem searched = problem.is_movable ? without_sizes(problem) : problem;
  Result result;
  const ChainSearchResult found =
      search_chains(chains, problem.solve, problem.raster ? between_values(run) : run, deadline,
                    result.work, known_starts(run.known, chains, scale));
  result.designs = designs_of_minima(searched, scale, found.designs);
  result.status = status_of(result.designs, deadline);
  result.quantities = quantities(found.statistics);
  if (problem.raster) {
    const ScaledChain scaled(problem, problem.topologies.front(), scale);
    take_raster(problem, scale, scaled, found.designs, run, deadline, result);
    result.status = status_of(result.designs, deadline);
  }
  return result;
}

/// The search of `problem` in units of its target, one for each topology.
std::vector<ScaledChain> scaled_chains(const ChainPathProblem& problem) {
  const TargetScale scale(problem.points);
  std::vector<ScaledChain> chains;
  for (const Topology& topology : problem.topologies) chains.emplace_back(problem, topology, scale);
  return chains;
}

/// By the stray between targets, if that is more than the error, but where the targets are met.
ChainFrontProblem front_of_path(const ChainPathProblem& problem) {
  const double size = TargetScale(problem.points).size, met = kMetError * size;
  const auto ranked = [met](const Design& design) {
    const double rms = design.error.rms;
    if (rms <= met) return rms;
    return std::max(rms, find_quantity(design.metrics.quantities, kStrayKey).value_or(0));
  };
  const auto solve = [&problem](const ChainDemand& demand, const Run& run, const Deadline& end) {
    const ChainPathProblem one = with_demand(problem, demand);
    return find_least_error(one, scaled_chains(one), run, end);
  };
  return {*problem.against,
          demand_of(problem),
          met,
          size,
          "rms_error",
          ranked,
          [](const Design& design) { return design.error.rms; },
          solve};
}

Result find_chains(const ChainPathProblem& problem, const std::vector<ScaledChain>& chains,
                   const Run& run, const Deadline& deadline) {
  if (is_given(problem)) return take_given(problem, deadline);
  if (problem.solve.robust) return find_robust_chains(problem, chains, run, deadline);
  if (!problem.against) return find_least_error(problem, chains, run, deadline);
  return chain_front(front_of_path(problem), run, deadline);
}

}  // namespace

Result solve(const ChainPathProblem& given, const Run& run) {
  const auto valid = KindTraits<ChainPathProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const ChainPathProblem& problem = *valid;
  const Deadline deadline(run);
  const ChainPathProblem searched = problem.is_movable ? without_sizes(problem) : problem;
  const std::vector<ScaledChain> chains = scaled_chains(searched);
  const auto source = is_given(problem) ? DesignSource::exact : DesignSource::search;
  Result result =
      solve_in_layers(problem, run, source, [&](const ChainPathProblem& one, const Run& own) {
        return find_chains(one, chains, own, deadline);
      });
  note_unknowns(problem, chains, result);
  add_warnings(extent_of(problem.points), problem.warnings, result);
  if (result.designs.empty()) {
    result.notes.emplace_back(
        is_given(problem)
            ? "The chain given cannot be assembled at every target point; change its dimensions."
            : "No chain was found that closes at every target point within the limits; wider "
              "bounds or limits or more starts may help.");
  }
  add_chain_tolerances(problem, run, result);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
