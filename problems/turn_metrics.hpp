/// @file What a finished four-bar does over the full turn of its crank, by the analysis kernel's
/// mechanisms and inverse dynamics on a dense table of crank angles, refined: no formula of
/// turn_limits.hpp enters.
#pragma once

#include "analysis/four_bar.hpp"
#include "problems/linkage_limits.hpp"
#include "problems/result.hpp"
#include "problems/turn_limits.hpp"

namespace cognate::problems {

/// The least distance over the turn by which the point keeps to its side of the box: of the nearest
/// side where it is to stay inside; the greatest distance beyond a side where it is to stay
/// outside. Negative where it does not, −∞ where the linkage does not close.
double clearance_distance(const FourBar& linkage, const Clearance& clearance);

/// The greatest acceleration at a constant crank speed (rad/s): length/s² of the coupler point,
/// rad/s² of the rocker. Infinite where the linkage does not close.
double peak_acceleration(const FourBar& linkage, Accelerated accelerated, double speed);

/// The greatest less the least driving torque. Infinite where the linkage does not close.
double torque_ripple(const FourBar& linkage, const Operation& operation);

/// Fills in of `metrics` what `constraints` limit.
void add_turn_metrics(const Constraints& constraints, const FourBar& linkage,
                      Accelerated accelerated, Metrics& metrics);

}  // namespace cognate::problems
