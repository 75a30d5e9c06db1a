#include "problems/machine/steady_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cognate::problems {
namespace {

/// An angle of the drive in its period, in degrees.
double degrees(double phi, double period) {
  return (phi - period * std::floor(phi / period)) * 180 / std::numbers::pi;
}

/// Over the states of a period: the greatest power of the motor, the range of kinetic energy.
struct StateExtremes {
  double power = -std::numeric_limits<double>::infinity();
  double least_energy = std::numeric_limits<double>::infinity(), greatest_energy = 0;
};

StateExtremes extremes(const machine::Machine& machine, const machine::SteadyState& steady) {
  StateExtremes found;
  for (const machine::MachineState& state : steady.states) {
    const double phi = state.phi - machine.period * std::floor(state.phi / machine.period);
    const double energy = 0.5 * machine.move_to(phi).value * state.omega * state.omega;
    const double power = machine.torques(state.omega, state.time).motor * state.omega;
    found.power = std::max(found.power, power);
    found.least_energy = std::min(found.least_energy, energy);
    found.greatest_energy = std::max(found.greatest_energy, energy);
  }
  return found;
}

}  // namespace

std::vector<Fact> steady_facts(const MachineProblem& problem, const machine::Machine& machine,
                               const machine::SteadyState& steady) {
  const StateExtremes found = extremes(machine, steady);
  std::vector<Fact> facts{
      {"speed_mean_rad_s", machine::mean_speed(steady)},
      {"speed_max_rad_s", steady.greatest.omega},
      {"speed_max_at_deg", degrees(steady.greatest.phi, machine.period)},
      {"speed_min_rad_s", steady.least.omega},
      {"speed_min_at_deg", degrees(steady.least.phi, machine.period)},
      {"fluctuation", machine::fluctuation(steady)},
      {"period_s", steady.period()},
      {"energy_swing_J", found.greatest_energy - found.least_energy},
      {"multiplier", steady.multiplier},
      {"energy_residual", steady.energy_residual},
  };
  if (problem.motor) {
    const double work = steady.states.back().motor_work;
    facts.push_back({"motor_work_J", work});
    facts.push_back({"motor_power_mean_W", work / steady.period()});
    facts.push_back({"motor_power_max_W", found.power});
  }
  return facts;
}

std::vector<Fact> flywheel_facts(const machine::Flywheel& flywheel) {
  return {
      {"flywheel_inertia_kg_m2", flywheel.inertia},
      {"flywheel_inertia_approximate_kg_m2", flywheel.approximate},
      {"greatest_excess_work_J", flywheel.greatest_excess},
      {"fluctuation_without_flywheel", machine::fluctuation(flywheel.without)},
  };
}

}  // namespace cognate::problems
