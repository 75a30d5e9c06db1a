/// @file A linkage that a crank drives, with masses and loads, and how it accelerates.
#pragma once

#include "problems/linkage/cycle_metrics.hpp"
#include "problems/linkage/operation.hpp"

namespace cognate::problems::test {

inline double peak_acceleration(const FourBar& linkage, CycleOutput output, double speed) {
  Operation operation;
  operation.speed = speed;
  return cycle_metric(CycleQuantity::peak_acceleration, linkage, output, operation);
}

inline Operation machine() {
  Operation operation;
  operation.speed = 1.7;
  operation.links[0] = {.centre = {.link = MovingLink::crank, .share = 0.5}, .mass_per_length = 2};
  operation.links[1] = {.mass = 1.5,
                        .centre = {.link = MovingLink::coupler, .share = 1, .offset = {-0.4, 0.3}},
                        .moment = 0.2};
  operation.links[2] = {.centre = {.link = MovingLink::rocker, .share = 0.5}, .mass_per_length = 3};
  operation.loads = {{{.link = MovingLink::coupler, .at_coupler_point = true}, {2, -3}, 0.5},
                     {{.link = MovingLink::rocker, .share = 1}, {0, 1}, 0},
                     {{.link = MovingLink::crank, .offset = {0.1, 0.2}}, {1, 1}, -0.3}};
  operation.gravity = {0.5, -9.8};
  return operation;
}

}  // namespace cognate::problems::test
