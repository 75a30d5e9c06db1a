/// @file What a finished four-bar does over the full turn of its crank, by the analysis kernel's
/// mechanisms and inverse dynamics on a dense table of crank angles, refined: no formula of
/// cycle_limits.hpp enters.
#pragma once

#include <string>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/cycle/cycle_limits.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The least distance over the turn by which the point satisfies its side of the box: of the
/// nearest side where it is to stay inside; the greatest distance beyond a side where it is to stay
/// outside. Negative where it does not, −∞ where the linkage does not close.
double clearance_distance(const FourBar& linkage, const Clearance& clearance);

/// A quantity over the turn in the unit of its declaration, at the speed and under the loads of
/// `operation`; `output` decides of what a speed or acceleration is. Infinite where the linkage
/// does not close.
double cycle_metric(CycleQuantity quantity, const FourBar& linkage, CycleOutput output,
                    const Operation& operation);

/// δ = (ω_max − ω_min)/ω of the steady motion of mean speed ω = ½ (ω_max + ω_min) under a driving
/// torque that is the same at every angle, the operation's flywheel included. The speed is the root
/// of twice the energy over the inertia, with its sign: from 2 on the machine stands still before
/// it has come round. Infinite where the linkage does not close or weighs nothing at some angle.
double speed_fluctuation(const FourBar& linkage, const Operation& operation);

/// The root of the mean of T² over the crank's turn at the operation's speed. Infinite where the
/// linkage does not close.
double rms_torque(const FourBar& linkage, const Operation& operation);

/// The least inertia of a flywheel on the crank with which that is at most the operation's
/// `fluctuation`, instead of its own flywheel; 0 where none is needed.
double flywheel_inertia(const FourBar& linkage, const Operation& operation);

/// Which velocities, accelerations and forces `constraints` does not need.
std::vector<std::string> skipped_evaluations(const Constraints& constraints);

/// Fills in of `metrics` what `constraints` limit or want to be known.
void add_cycle_metrics(const Constraints& constraints, const FourBar& linkage, CycleOutput output,
                       Metrics& metrics);

}  // namespace cognate::problems
