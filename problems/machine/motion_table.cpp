#include "problems/machine/motion_table.hpp"

#include <array>
#include <cmath>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems {
namespace {

struct NamedColumn {
  const char* name;
  const char* quantity;
  const char* unit;
};

constexpr std::array<NamedColumn, 14> kColumns{{{"time_s", "time", "s"},
                                                {"crank_deg", "drive", "deg"},
                                                {"speed_rad_s", "speed", "rad/s"},
                                                {"acceleration_rad_s2", "acceleration", "rad/s²"},
                                                {"inertia_kg_m2", "inertia", "kg m²"},
                                                {"inertia_slope_kg_m2", "inertia", "kg m²/rad"},
                                                {"motor_N_m", "torque", "N m"},
                                                {"load_N_m", "torque", "N m"},
                                                {"motor_power_W", "power", "W"},
                                                {"load_power_W", "power", "W"},
                                                {"motor_work_J", "work", "J"},
                                                {"load_work_J", "work", "J"},
                                                {"kinetic_energy_J", "work", "J"},
                                                {"excess_work_J", "work", "J"}}};

std::array<double, kColumns.size()> row(const machine::Machine& machine,
                                        const machine::MachineState& state) {
  const auto& [time, phi, omega, motor_work, load_work] = state;
  const auto inertia = machine.move_to(in_period(phi, machine.period));
  const auto [motor, load] = machine.torques(omega, time);
  const double acceleration = (motor + load - 0.5 * omega * omega * inertia.slope) / inertia.value;
  return {time,
          phi * 180 / kPi,
          omega,
          acceleration,
          inertia.value,
          inertia.slope,
          motor,
          load,
          motor * omega,
          load * omega,
          motor_work,
          load_work,
          0.5 * inertia.value * omega * omega,
          motor_work + load_work};
}

}  // namespace

std::vector<Column> motion_table(const machine::Machine& machine,
                                 std::span<const machine::MachineState> states) {
  std::vector<Column> columns;
  for (const auto& [name, quantity, unit] : kColumns) {
    columns.push_back({.name = name, .quantity = quantity, .of = "", .unit = unit, .values = {}});
    columns.back().values.reserve(states.size());
  }
  for (const machine::MachineState& state : states) {
    const auto values = row(machine, state);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i].values.push_back(std::isfinite(values[i]) ? values[i] + 0.0 : std::nan(""));
    }
  }
  return columns;
}

}  // namespace cognate::problems
