/// @file A linkage that a crank drives, with masses and loads, and how it accelerates.
#pragma once

#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/cycle/operation.hpp"

namespace cognate::test {

inline double peak_acceleration(const FourBar& linkage, problems::CycleOutput output,
                                double speed) {
  problems::Operation operation;
  operation.speed = speed;
  return problems::cycle_metric(problems::CycleQuantity::peak_acceleration, linkage, output,
                                operation);
}

inline problems::Operation machine() {
  problems::Operation operation;
  operation.speed = 1.7;
  operation.links[0] = {.centre = {.link = problems::MovingLink::crank, .share = 0.5},
                        .mass_per_length = 2};
  operation.links[1] = {
      .mass = 1.5,
      .centre = {.link = problems::MovingLink::coupler, .share = 1, .offset = {-0.4, 0.3}},
      .moment = 0.2};
  operation.links[2] = {.centre = {.link = problems::MovingLink::rocker, .share = 0.5},
                        .mass_per_length = 3};
  operation.loads = {
      {{.link = problems::MovingLink::coupler, .at_coupler_point = true}, {2, -3}, 0.5},
      {{.link = problems::MovingLink::rocker, .share = 1}, {0, 1}, 0},
      {{.link = problems::MovingLink::crank, .offset = {0.1, 0.2}}, {1, 1}, -0.3}};
  operation.gravity = {0.5, -9.8};
  return operation;
}

}  // namespace cognate::test
