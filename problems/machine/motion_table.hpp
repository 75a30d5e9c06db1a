/// @file The motion of a machine as a table.
#pragma once

#include <span>
#include <vector>

#include "analysis/machine/machine.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::problems {

/// A row for each state: time_s, crank_deg (counted on from turn to turn), speed_rad_s,
/// acceleration_rad_s2, inertia_kg_m2, inertia_slope_kg_m2 (by radian), motor_N_m and load_N_m (at
/// the drive), motor_power_W, load_power_W, motor_work_J, load_work_J, kinetic_energy_J and
/// excess_work_J, the work of both since the first row.
std::vector<Column> motion_table(const machine::Machine& machine,
                                 std::span<const machine::MachineState> states);

}  // namespace cognate::problems
