#include "problems/chain/scaled.hpp"

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

}  // namespace cognate::problems
