#include "problems/machine/steady_quantities.hpp"

#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems {
namespace {

/// A speed that is even to within so many tolerances has no place where it is greatest.
constexpr double kEven = 10;

double degrees(double phi, double period) {
  return in_period(phi, period) * 360 / kTurn;
}

}  // namespace

std::vector<Quantity> steady_quantities(const MachineProblem& problem,
                                        const machine::Machine& machine,
                                        const machine::SteadyState& steady) {
  const bool is_even = machine::fluctuation(steady) <= kEven * problem.run.tolerance;
  std::vector<Quantity> quantities{{"speed_mean_rad_s", machine::mean_speed(steady)},
                                   {"speed_max_rad_s", steady.greatest.omega}};
  const auto add_place = [&](const char* name, const machine::SpeedAt& at) {
    if (!is_even) quantities.push_back({name, degrees(at.phi, machine.period)});
  };
  add_place("speed_max_at_deg", steady.greatest);
  quantities.push_back({"speed_min_rad_s", steady.least.omega});
  add_place("speed_min_at_deg", steady.least);
  quantities.push_back({"fluctuation", machine::fluctuation(steady)});
  quantities.push_back({"period_s", steady.period()});
  quantities.push_back({"energy_swing_J", steady.energy_swing});
  quantities.push_back({"multiplier", steady.multiplier});
  quantities.push_back({"energy_residual", steady.energy_residual});
  if (problem.motor) {
    const double work = steady.states.back().motor_work;
    quantities.push_back({"motor_work_J", work});
    quantities.push_back({"motor_power_mean_W", work / steady.period()});
    quantities.push_back({"motor_power_max_W", steady.motor_power});
  }
  return quantities;
}

std::vector<Quantity> flywheel_quantities(const machine::Flywheel& flywheel) {
  std::vector<Quantity> quantities{{"flywheel_inertia_kg_m2", flywheel.inertia}};
  if (flywheel.without.states.empty()) return quantities;
  quantities.push_back({"flywheel_inertia_approximate_kg_m2", flywheel.approximate});
  quantities.push_back({"greatest_excess_work_J", flywheel.greatest_excess});
  quantities.push_back({"fluctuation_without_flywheel", machine::fluctuation(flywheel.without)});
  return quantities;
}

}  // namespace cognate::problems
