/// @file What is reported of a machine's steady state and its flywheel.
#pragma once

#include <vector>

#include "analysis/machine/flywheel.hpp"
#include "analysis/machine/steady_state.hpp"
#include "problems/basics/quantity.hpp"
#include "problems/machine/problem.hpp"

namespace cognate::problems {

/// speed_mean_rad_s, speed_max_rad_s, speed_max_at_deg, speed_min_rad_s, speed_min_at_deg (places
/// of a speed that is not even),
/// fluctuation, period_s, energy_swing_J (greatest less least kinetic energy), multiplier,
/// energy_residual, and with a motor motor_work_J (of a period), motor_power_mean_W,
/// motor_power_max_W, both at the drive.
std::vector<Quantity> steady_quantities(const MachineProblem& problem,
                                        const machine::Machine& machine,
                                        const machine::SteadyState& steady);

/// flywheel_inertia_kg_m2, and where the machine runs without one
/// flywheel_inertia_approximate_kg_m2, greatest_excess_work_J, fluctuation_without_flywheel.
std::vector<Quantity> flywheel_quantities(const machine::Flywheel& flywheel);

}  // namespace cognate::problems
