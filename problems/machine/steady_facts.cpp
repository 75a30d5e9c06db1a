#include "problems/machine/steady_facts.hpp"

#include <cmath>
#include <numbers>

namespace cognate::problems {
namespace {

/// An angle of the drive in its period, in degrees.
double degrees(double phi, double period) {
  return (phi - period * std::floor(phi / period)) * 180 / std::numbers::pi;
}

}  // namespace

std::vector<Fact> steady_facts(const MachineProblem& problem, const machine::Machine& machine,
                               const machine::SteadyState& steady) {
  std::vector<Fact> facts{
      {"speed_mean_rad_s", machine::mean_speed(steady)},
      {"speed_max_rad_s", steady.greatest.omega},
      {"speed_max_at_deg", degrees(steady.greatest.phi, machine.period)},
      {"speed_min_rad_s", steady.least.omega},
      {"speed_min_at_deg", degrees(steady.least.phi, machine.period)},
      {"fluctuation", machine::fluctuation(steady)},
      {"period_s", steady.period()},
      {"energy_swing_J", steady.energy_swing},
      {"multiplier", steady.multiplier},
      {"energy_residual", steady.energy_residual},
  };
  if (problem.motor) {
    const double work = steady.states.back().motor_work;
    facts.push_back({"motor_work_J", work});
    facts.push_back({"motor_power_mean_W", work / steady.period()});
    facts.push_back({"motor_power_max_W", steady.motor_power});
  }
  return facts;
}

std::vector<Fact> flywheel_facts(const machine::Flywheel& flywheel) {
  std::vector<Fact> facts{{"flywheel_inertia_kg_m2", flywheel.inertia}};
  if (flywheel.without.states.empty()) return facts;
  facts.push_back({"flywheel_inertia_approximate_kg_m2", flywheel.approximate});
  facts.push_back({"greatest_excess_work_J", flywheel.greatest_excess});
  facts.push_back({"fluctuation_without_flywheel", machine::fluctuation(flywheel.without)});
  return facts;
}

}  // namespace cognate::problems
