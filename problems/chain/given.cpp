#include "problems/chain/given.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/crank_angles/in_order.hpp"
#include "problems/chain/crank_angles/starts.hpp"
#include "problems/chain/refine.hpp"
#include "problems/chain/scaled.hpp"
#include "problems/chain/verify.hpp"

namespace cognate::problems {
namespace {

constexpr int kPhasesInTurn = 24;  ///< from each of which that of a timed path is refined
/// A refinement moves each crank angle half of the way to its neighbours at most: it is repeated
/// while the error falls by more than this share.
constexpr double kSettled = 1e-12;
constexpr int kMostRefinements = 30;

bool is_given(const TopologyLine& line) {
  const auto count = static_cast<std::size_t>(parameter_count(line.line.type));
  for (std::size_t i = 0; i < count; ++i) {
    if (!line.given[i]) return false;
  }
  return !is_dyad(line.line.type) || line.assembly;
}

/// The dimensions that the file gives, in its unit.
synthesis::ChainDesign given_dimensions(const Topology& topology) {
  synthesis::ChainDesign design;
  for (const TopologyLine& line : topology.lines) {
    const auto count = static_cast<std::size_t>(parameter_count(line.line.type));
    for (std::size_t i = 0; i < count; ++i) design.parameters.push_back(*line.given[i]);
    const int side = line.assembly == Assembly::crossed ? -1 : 1;
    design.side.push_back(is_dyad(line.line.type) ? side : 0);
  }
  return design;
}

/// Crank angles from which those of the targets are refined; of a timed path phases.
std::vector<std::vector<double>> first_angles(const ScaledChain& problem,
                                              const synthesis::ChainDesign& design) {
  if (problem.timed()) return first_phases(problem, design, kPhasesInTurn);
  return ordered_angles(problem, design);
}

RefinedChain settled(const ScaledChain& problem, const synthesis::ChainDesign& design,
                     const std::vector<double>& angles) {
  const auto refined = [&](const std::vector<double>& from) {
    return refine(problem, design, from, synthesis::Solver::gauss_newton, {.tolerance = 1e-13});
  };
  RefinedChain best = refined(angles);
  for (int i = 0; i < kMostRefinements && std::isfinite(best.objective); ++i) {
    RefinedChain next = refined(best.angles);
    if (!(next.objective < best.objective)) break;
    const bool is_settled = next.objective > (1 - kSettled) * best.objective;
    best = std::move(next);
    if (is_settled || problem.timed()) break;
  }
  return best;
}

/// The crank angles of the least error; empty where the chain does not close at all targets.
std::vector<double> nearest_angles(const ScaledChain& problem) {
  synthesis::ChainDesign design = given_dimensions(*problem.topology);
  for (std::size_t i = 0; i < problem.given.size(); ++i) design.parameters[i] = *problem.given[i];
  RefinedChain best;
  best.objective = std::numeric_limits<double>::infinity();
  for (const auto& angles : first_angles(problem, design)) {
    RefinedChain found = settled(problem, design, angles);
    if (found.objective < best.objective) best = std::move(found);
  }
  if (!problem.timed() || best.angles.empty()) return best.angles;
  std::vector<double> all = problem.crank_angles;
  for (double& angle : all) angle += best.angles.front();
  return all;
}

}  // namespace

bool is_given(const Topology& topology) {
  return std::ranges::all_of(topology.lines,
                             [](const TopologyLine& line) { return is_given(line); });
}

NamedMechanism given_mechanism(const Topology& topology) {
  return named(topology, given_dimensions(topology));
}

bool is_given(const ChainPathProblem& problem) {
  return problem.topologies.size() == 1 && is_given(problem.topologies.front()) &&
         !problem.raster && !problem.solve.robust;
}

std::optional<Design> given_design(const ChainPathProblem& problem) {
  const Topology& topology = problem.topologies.front();
  const TargetScale scale(problem.points);
  const auto angles = nearest_angles(ScaledChain(problem, topology, scale));
  if (angles.empty()) return std::nullopt;
  Design design = verified(problem, topology, given_mechanism(topology), angles);
  if (!std::isfinite(design.error.sum_of_squares)) return std::nullopt;
  design.origin = "given";
  return design;
}

}  // namespace cognate::problems
