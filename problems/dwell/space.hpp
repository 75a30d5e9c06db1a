/// @file Which dimensions of a mechanism with dwells are sought, and within what.
#pragma once

#include "problems/chain/space.hpp"
#include "problems/dwell/problem.hpp"

namespace cognate::problems {

/// The problem of one topology. The unit is the crank where its length is known. What moves, turns
/// or enlarges the whole mechanism changes no angle: as far as the file leaves these open, the
/// crank has the length 1 (or the nearest that its bounds allow) and turns about the origin, and
/// the first other pivot is level with its own, unless crank angles of dwells are given.
struct DwellSpace : ChainSpace {
  TargetScale scale;
  int from, to;      ///< lines of the output's points
  double swing_min;  ///< of the problem, with what a search may miss it by
  const DwellProblem* problem;

  DwellSpace(const DwellProblem& problem, const Topology& topology);

 private:
  DwellSpace(const DwellProblem& problem, const Topology& topology, const Topology& framed);
};

/// The angle of `way` relative to `reference`: within half a turn of it.
double relative_angle(const Vec2d& way, const Vec2d& reference);

}  // namespace cognate::problems
