/// Motion generation by chains from problem to designs: search, conversion to the file's units,
/// verification.

#include <vector>

#include "analysis/numbers/parallel.hpp"
#include "problems/chain/found_designs.hpp"
#include "problems/chain/front/front.hpp"
#include "problems/chain/minima_designs.hpp"
#include "problems/chain/scaled.hpp"
#include "problems/chain/search.hpp"
#include "problems/chain/starts/known.hpp"
#include "problems/chain_motion/problem.hpp"
#include "problems/chain_motion/verify.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {
namespace {

/// The search in units of the target, one for each topology.
std::vector<ScaledChain> scaled_chains(const ChainMotionProblem& problem) {
  const ChainPathProblem path = path_of(problem);
  const TargetScale scale = scale_of(problem);
  std::vector<double> angles;
  for (const synthesis::Pose& pose : problem.poses) angles.push_back(pose.angle);
  std::vector<ScaledChain> chains;
  for (const Topology& topology : problem.topologies) {
    chains.emplace_back(path, topology, scale)
        .add_headings(angles, angle_weight_of(problem) / scale.size);
  }
  return chains;
}

Result find_motions(const ChainMotionProblem& problem, const std::vector<ScaledChain>& chains,
                    const Run& run, const Deadline& deadline) {
  Result result;
  const ChainSearchResult found = search_chains(chains, problem.solve, run, deadline, result.work,
                                                known_starts(run.known, chains, scale_of(problem)));
  result.designs = designs_of_minima(problem.solve, found.designs, [&](const ChainMinimum& one) {
    return verified(problem, one);
  });
  result.status = status_of(result.designs, deadline);
  result.quantities = quantities(found.statistics);
  return result;
}

ChainFrontProblem front_of_motion(const ChainMotionProblem& problem) {
  const double size = scale_of(problem).size;
  const auto error = [](const Design& design) { return design.error.rms; };
  const auto solve = [&problem](const ChainDemand& demand, const Run& run, const Deadline& end) {
    const ChainMotionProblem one = with_demand(problem, demand);
    return find_motions(one, scaled_chains(one), run, end);
  };
  return {*problem.against,
          demand_of(problem),
          kMetError * size,
          size,
          "rms_error",
          error,
          error,
          solve};
}

/// The place of the body's origin at the nominal crank angles.
void add_origin_tolerances(const ChainMotionProblem& problem, const Run& run, Result& result) {
  const std::vector<Vec2d> origins = path_of(problem).points;
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) {
        return error_at_targets(design.mechanism, origin_name(problem), design.crank_angles,
                                origins, true);
      },
      result);
}

/// Whether the dimensions can be chosen so that every pose is met: a pose is three equations, of
/// which the crank's angle takes one where it is free.
void note_freedom(const ChainMotionProblem& problem, const std::vector<ScaledChain>& chains,
                  Result& result) {
  std::size_t unknowns = 0;
  for (const ScaledChain& chain : chains) unknowns = std::max(unknowns, chain.free.size());
  const bool timed = !problem.crank_angles.empty();
  const std::size_t equations = (timed ? 3 : 2) * problem.poses.size();
  if (equations >= unknowns + (timed ? 1 : 0)) return;
  result.notes.emplace_back(
      "The target has fewer poses than the chain has dimensions: infinitely many designs may meet "
      "it exactly. Give more poses to define the motion between them.");
}

}  // namespace

Result solve(const ChainMotionProblem& given, const Run& run) {
  const auto valid = KindTraits<ChainMotionProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const ChainMotionProblem& problem = *valid;
  const Deadline deadline(run);
  const std::vector<ScaledChain> chains = scaled_chains(problem);
  Result result = solve_in_layers(
      problem, run, DesignSource::search, [&](const ChainMotionProblem& one, const Run& own) {
        return one.against ? chain_front(front_of_motion(one), own, deadline)
                           : find_motions(one, chains, own, deadline);
      });
  note_freedom(problem, chains, result);
  add_warnings(extent_of(path_of(problem).points), problem.warnings, result);
  if (result.designs.empty()) {
    result.notes.emplace_back(
        "No chain was found that closes at every pose within the limits; wider bounds or limits or "
        "more starts may help.");
  }
  add_origin_tolerances(problem, run, result);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
