#include "tests/browser/sample_gears.hpp"

#include <utility>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

GearProblem gear(int teeth) {
  GearProblem problem;
  problem.title = "Sample gear";
  problem.gear.normal.teeth = teeth;
  problem.gear.normal.module = 5;
  return problem;
}

GearPairProblem pair(int pinion, int wheel, double centre_distance) {
  GearPairProblem problem;
  problem.title = "Sample pair";
  problem.teeth = {pinion, wheel};
  problem.module = 5;
  problem.profile_shift = {0.0, 0.0};
  problem.centre_distance = centre_distance;
  return problem;
}

GearPairProblem helical() {
  GearPairProblem problem = pair(20, 45, 170);
  problem.gearing = Gearing::helical;
  problem.helix = 15 * kDegree;
  problem.face_width = 40;
  return problem;
}

GearPairProblem bevel() {
  GearPairProblem problem = pair(20, 40, 0);
  problem.gearing = Gearing::bevel;
  problem.centre_distance.reset();
  problem.face_width = 25;
  return problem;
}

GearPairProblem worm() {
  GearPairProblem problem;
  problem.title = "Sample worm";
  problem.gearing = Gearing::worm;
  problem.module = 4;
  problem.worm = {.starts = 2, .wheel_teeth = 40, .module = 4, .rack = problem.rack};
  problem.friction = 0.06;
  return problem;
}

/// Pairs of a ratio, of which several are found.
GearPairProblem searched() {
  GearPairProblem problem;
  problem.title = "Sample search";
  problem.module = 4;
  problem.teeth_bounds = {{{17, 21}, {58, 72}}};
  problem.ratio = 3.5;
  problem.ratio_tolerance = 0.02;
  return problem;
}

}  // namespace

std::vector<SampleGear> sample_gears() {
  return {{"gear", gear(35)},
          {"undercut", gear(9)},
          {"pair", pair(20, 80, 250)},
          {"lost", pair(20, 80, 255)},
          {"overlap", pair(20, 80, 249)},
          {"helical", helical()},
          {"bevel", bevel()},
          {"worm", worm()},
          {"search", searched()}};
}

}  // namespace cognate::problems
