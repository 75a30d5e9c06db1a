#include "problems/chain/minima_designs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/basics/quantity_key.hpp"
#include "problems/chain/verify.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/search/solver_origin.hpp"

namespace cognate::problems {
namespace {

/// Designs whose dimensions differ by less, relative to the target, are one: they are in one
/// valley.
constexpr double kSameDimensions = 0.03;

bool is_known(const std::vector<ChainMinimum>& taken, const ChainMinimum& other) {
  return std::ranges::any_of(taken, [&](const ChainMinimum& known) {
    if (known.problem != other.problem || known.design.side != other.design.side) return false;
    const auto& a = known.design.parameters;
    const auto& b = other.design.parameters;
    double apart = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      apart = std::max(apart, std::abs(a[i] - b[i]) / std::max(1.0, std::abs(a[i])));
    }
    return apart < kSameDimensions;
  });
}

}  // namespace

std::vector<double> angles_of_targets(const ChainMinimum& found) {
  if (!found.problem->timed()) return found.angles;
  std::vector<double> angles = found.problem->crank_angles;
  for (double& angle : angles) angle += found.angles.front();
  return angles;
}

std::vector<Design> designs_of_minima(const Solve& options, const std::vector<ChainMinimum>& found,
                                      const std::function<Design(const ChainMinimum&)>& verify) {
  std::vector<Design> feasible, others;
  // By themselves: a design that misses a limit by little does not stand for its neighbour that
  // meets it.
  std::vector<ChainMinimum> taken_feasible, taken_others;
  for (ChainMinimum one : found) {
    one.design = with_guides_forward(*one.problem, std::move(one.design));
    Design design = verify(one);
    if (!std::isfinite(design.error.sum_of_squares)) continue;
    const bool is_feasible = all_satisfied(design.constraints);
    auto& taken = is_feasible ? taken_feasible : taken_others;
    if (is_known(taken, one)) continue;
    taken.push_back(one);
    design.origin = search_origin(synthesis::chosen(options.solver));
    (is_feasible ? feasible : others).push_back(std::move(design));
  }
  auto& best = feasible.empty() ? others : feasible;
  const auto wanted = static_cast<std::size_t>(options.designs);
  if (best.size() > wanted) best.resize(wanted);
  return std::move(best);
}

std::vector<Design> designs_of_minima(const ChainPathProblem& problem, const TargetScale& scale,
                                      const std::vector<ChainMinimum>& found) {
  return designs_of_minima(problem.solve, found, [&](const ChainMinimum& one) {
    const Topology& topology = *one.problem->topology;
    auto mechanism = named(topology, scale.out_of(one.problem->chain, one.design));
    Design design = verified(problem, topology, std::move(mechanism), angles_of_targets(one));
    if (one.stray > 0) {
      design.metrics.quantities.push_back(quantity(kStrayKey, scale.size * one.stray));
    }
    return design;
  });
}

}  // namespace cognate::problems
