/// @file Mechanisms with the names of their parts, as a file would give them, for tests.
#pragma once

#include "analysis/linkage/double_slider.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::problems {

inline AnalysisProblem analysis_of(NamedMechanism mechanism, int steps) {
  AnalysisProblem problem;
  problem.inertias.resize(mechanism.bodies.size());
  problem.mechanism = std::move(mechanism);
  problem.drive = {.start = 0, .end = kTurn, .steps = steps, .rate = {.speed = 1}};
  return problem;
}

inline NamedMechanism named(const FourBar& linkage) {
  NamedMechanism named;
  named.mechanism = as_mechanism(linkage);
  named.bodies = {"frame", "crank", "coupler", "rocker"};
  named.points = {{"A", {0, linkage.pivot_a}},
                  {"B", {1, {linkage.crank, 0}}},
                  {"C", {3, {linkage.rocker, 0}}},
                  {"D", {0, linkage.pivot_d}}};
  if (linkage.coupler_point) named.points.push_back({"P", {2, *linkage.coupler_point}});
  named.output = 3;
  named.description = linkage;
  return named;
}

inline NamedMechanism named(const SliderCrank& mechanism) {
  NamedMechanism named;
  named.mechanism = as_mechanism(mechanism);
  named.bodies = {"frame", "crank", "coupler", "slider"};
  named.points = {{"A", {0, mechanism.pivot}}, {"B", {1, {mechanism.crank, 0}}}, {"C", {3, {}}}};
  named.output = 3;
  named.description = mechanism;
  return named;
}

inline NamedMechanism named(const GuideBar& mechanism) {
  NamedMechanism named;
  named.mechanism = as_mechanism(mechanism);
  named.bodies = {"frame", "crank", "block", "bar"};
  named.points = {{"A", {0, mechanism.pivot_a}}, {"B", {1, {mechanism.crank, 0}}}, {"D", {3, {}}}};
  named.output = 3;
  named.description = mechanism;
  return named;
}

inline NamedMechanism named(const ScotchYoke& mechanism) {
  NamedMechanism named;
  named.mechanism = as_mechanism(mechanism);
  named.bodies = {"frame", "crank", "block", "yoke"};
  named.points = {{"A", {0, mechanism.pivot}}, {"B", {1, {mechanism.crank, 0}}}, {"C", {3, {}}}};
  named.output = 3;
  named.description = mechanism;
  return named;
}

inline NamedMechanism named(const EllipticTrammel& mechanism) {
  NamedMechanism named;
  named.mechanism = as_mechanism(mechanism);
  named.bodies = {"frame", "link", "first-block", "second-block"};
  named.points = {{"A", {1, {}}}, {"B", {1, {mechanism.length, 0}}}};
  named.output = 3;
  named.description = mechanism;
  return named;
}

}  // namespace cognate::problems
