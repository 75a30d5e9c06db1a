#include "problems/chain/scaled.hpp"

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

ScaledChain::ScaledChain(const ChainPathProblem& problem, const Topology& of,
                         const TargetScale& scale)
    : ChainSpace(of, scale, problem.constraints.transmission_angle),
      crank_angles(problem.crank_angles),
      closed(problem.closed),
      is_movable(problem.is_movable),
      over_turn(problem.constraints.over == LimitSpan::turn) {
  for (const Vec2d& point : problem.points) points.push_back(scale.into(point));
}

void ScaledChain::add_headings(std::span<const double> angles, double weight) {
  chain.lines.push_back({synthesis::LineType::heading, topology->trace});
  headings.line = static_cast<int>(lines.size());
  lines = placed_lines(chain);
  free.push_back(static_cast<int>(given.size()));
  given.emplace_back();
  lower.push_back(-kTurn);
  upper.push_back(kTurn);
  for (const double angle : angles) headings.directions.push_back(unit_vector(angle));
  headings.weight = weight;
}

}  // namespace cognate::problems
