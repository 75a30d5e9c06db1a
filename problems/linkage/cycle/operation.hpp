/// @file Operating conditions assumed in synthesis: drive speed, masses, loads, gravity.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/mechanism/load_rule.hpp"

namespace cognate::problems {

/// A joint or point that moves over the turn.
enum class MovingPoint { coupler_point, b, c };

/// A body that moves, in the order of `Operation::links`.
enum class MovingLink { crank, coupler, rocker };

/// A place fixed on a link whose length l is not known: (share·l, 0) + `offset` in the link's axes
/// (origin A, B or D, first axis towards B, C or C), or, of the coupler, its coupler point.
struct LinkPlace {
  MovingLink link = MovingLink::coupler;
  double share = 0;
  Vec2d offset{};
  bool at_coupler_point = false;
};

/// Mass properties of a link: what is given once and for all, and what grows with its length l as
/// that of a slender rod, ρl at its middle with the moment ρl³/12 about it.
struct LinkMass {
  double mass = 0;             ///< kg
  LinkPlace centre;            ///< of `mass`, or of the rod
  double moment = 0;           ///< kg·m², about the centre of mass
  double mass_per_length = 0;  ///< ρ, kg/m
};

/// `[[load]]`: a force (N, global axes) and a torque (N·m) that act all the time or, on the rocker
/// of a crank-rocker, in one of its strokes.
struct WorkingLoad {
  LinkPlace at;
  Vec2d force{};
  double torque = 0;
  LoadSense sense = LoadSense::always;
};

/// `[drive]`, `[flywheel]`, `[[link]]`, `[[load]]` and `gravity` of a design problem. Torques are
/// in N·m where lengths are in m; in another unit for `in_joules`.
struct Operation {
  double speed = 1;        ///< of the crank, rad/s: constant, or its mean where the speed may vary
  double flywheel = 0;     ///< inertia that turns with the crank, kg·m²
  double fluctuation = 0;  ///< that a flywheel is to leave, where one is sought
  std::array<LinkMass, 3> links{};
  std::vector<WorkingLoad> loads;
  Vec2d gravity{};  ///< acceleration of free fall
};

/// `operation` of lengths in units of `metres`, with masses and forces so large that torques come
/// out in N·m, inertias in kg·m² and powers in W.
Operation in_joules(Operation operation, double metres);

/// `problem` of a kind with `constraints` and `length_unit`, its operation so.
template <class Problem>
Problem in_joules(Problem problem) {
  problem.constraints.operation =
      in_joules(std::move(problem.constraints.operation), metres(problem.length_unit));
  return problem;
}

}  // namespace cognate::problems
