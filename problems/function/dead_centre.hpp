/// @file Start angles at a limit position of the rocker, and how they move with the lengths.
#pragma once

#include <optional>

#include "analysis/linkage/four_bar.hpp"
#include "problems/function/problem.hpp"

namespace cognate::problems {

/// Crank and rocker angle from A→D at a dead centre, with their derivatives by the lengths.
struct DeadCentre {
  double crank_angle = 0;
  double rocker_angle = 0;
  Lengths<double> crank_slope;
  Lengths<double> rocker_slope;
};

/// The dead centre that `start` names; empty where the linkage has none. From the closure with
/// crank and coupler collinear, s·e₁ = l₄ + l₃·e₃ with s = l₁ ± l₂, projected on e₃ and on e₁.
std::optional<DeadCentre> dead_centre(const Lengths<double>& links, Assembly assembly,
                                      FunctionStart start);

}  // namespace cognate::problems
