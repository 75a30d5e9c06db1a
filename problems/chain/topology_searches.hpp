/// @file Searches of several topologies of chains, each an explorer of its own.
#pragma once

#include <cstdint>
#include <list>
#include <span>
#include <utility>
#include <vector>

#include "problems/basics/quantity_key.hpp"
#include "problems/chain/space.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {

/// How a solver fits one start of a search, until the deadline.
inline synthesis::Options fit_options(const synthesis::Deadline& deadline, int iterations) {
  return synthesis::until(deadline,
                          {.tolerance = 1e-9, .feasibility = 1e-9, .max_iterations = iterations});
}

/// The same by Gauss-Newton, to `tolerance` of the objective. Largest residuals that are equal
/// leave directions in which only curvature holds a design.
inline synthesis::Options fit_options(const synthesis::Deadline& deadline, int iterations,
                                      double tolerance) {
  synthesis::Options options = fit_options(deadline, iterations);
  options.tolerance = tolerance;
  options.learns_curvature = true;
  return options;
}

/// The minimum by Gauss-Newton; where its steps do not lead within the limits to `feasible`, by a
/// solver whose steps may leave them for a while.
inline synthesis::Solution minimum_within(const synthesis::Model& model,
                                          std::span<const double> start,
                                          const synthesis::Options& options, double feasible,
                                          const synthesis::WorkCounter& work) {
  auto solution = synthesis::solve(synthesis::Solver::gauss_newton, model, start, options);
  work.count(solution);
  if (solution.violation <= feasible) return solution;
  solution = synthesis::solve(synthesis::Solver::slsqp, model, start, options);
  work.count(solution);
  return solution;
}

/// An explorer of each space, made of it, its number and `context`: each in turn begins with what
/// is `known` of its space, explores by `rule` and finishes, in equal shares of the progress.
template <class Explorer, class Spaces, class Known, class... Context>
std::list<Explorer> explored(const Spaces& spaces, const Known& known,
                             const synthesis::StartRule& rule, const Context&... context) {
  constexpr double kExploring = 0.9;  // of the share
  std::list<Explorer> explorers;
  const double step = 1.0 / static_cast<double>(spaces.size());
  for (const auto& space : spaces) {
    const double share = step * static_cast<double>(explorers.size());
    Explorer& one = explorers.emplace_back(space, explorers.size(), context...);
    one.begin_with(known(space));
    one.explore(rule, {share, share + kExploring * step});
    one.finish({share + kExploring * step, share + step});
  }
  return explorers;
}

/// The dimensions of those designs of a `space` that are known, in its unit and bounds, each with
/// its design.
template <class Space>
std::vector<std::pair<synthesis::ChainDesign, const Design*>> known_chains(
    const Space& space, const TargetScale& scale, const std::vector<Design>& known) {
  std::vector<std::pair<synthesis::ChainDesign, const Design*>> chains;
  for (const Design& design : known) {
    const auto name =
        find_quantity(design.metrics.quantities, QuantityKey<std::string>{"topology"});
    if (name != space.topology->name) continue;
    const auto own = dimensions(*space.topology, design.mechanism);
    chains.emplace_back(within_bounds(space, scale.into(space.chain, own)), &design);
  }
  return chains;
}

/// Of the topology of the best of `designs`, sorted; the starts of all.
template <class Explorer, class Designs>
synthesis::SearchStatistics statistics_of(const std::list<Explorer>& explorers,
                                          const Designs& designs) {
  synthesis::SearchStatistics statistics;
  int starts = 0;
  for (const Explorer& one : explorers) {
    starts += one.search().starts();
    if (designs.empty() || &one.space() != designs.front().space) continue;
    statistics = one.search().statistics(synthesis::kBestMinima);
  }
  statistics.starts = starts;
  return statistics;
}

/// Adds what explorers and their solvers did, each evaluation of `nodes` positions.
template <class Explorer>
void count_work(const synthesis::WorkCounter& counter, const std::list<Explorer>& explorers,
                int nodes, Work& work) {
  for (const Explorer& one : explorers) {
    work.candidates += static_cast<std::uint64_t>(one.search().starts());
  }
  const auto done = counter.total();
  work.positions += done.evaluations * static_cast<std::uint64_t>(nodes);
  work.gradients += done.gradients;
  work.solver_iterations += done.iterations;
}

}  // namespace cognate::problems
