/// Prints, as markdown, how long it takes to find the periodic motion of a machine and how wrong it
/// is: by shooting with adaptive steps, as the library does, and by running the machine until its
/// turns repeat: with explicit Euler steps of the drive (the textbooks' way) and classical
/// Runge-Kutta steps, and by simulation in time.
///
/// The machine is a slider-crank whose load is such that a given speed is exactly its periodic one;
/// errors are those of the speed over a turn, relative. Every method runs in turn, several times
/// over; the least time of each counts.
#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "analysis/machine/reduction.hpp"
#include "analysis/machine/run.hpp"
#include "analysis/machine/steady_state.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::bench {
namespace {

using namespace machine;

constexpr int kRounds = 5;
/// Turns of a run until they repeat, at most; they do where the speed at 0 changes by no more than
/// this part from one to the next.
constexpr int kMostTurns = 20000;
constexpr double kRepeats = 1e-14;

double planted(double phi) {
  return 20 + 1.5 * std::sin(phi) + 0.5 * std::cos(3 * phi);
}
double planted_slope(double phi) {
  return 1.5 * std::cos(phi) - 1.5 * std::sin(3 * phi);
}

/// The machine, its flywheel and what it stands at.
class Planted {
 public:
  explicit Planted(double flywheel)
      : motion_({Crank<double>{{}, 0.2}, {Rrp<double>{{1, {0.2, 0}}, 0.5, {0, {}, {1, 0}, 0.05}}}}),
        inertias_{{}, {0, {}, 3}, {5, {0.2, 0}, 0.15}, {10}},
        flywheel_(flywheel) {}

  EquivalentInertia move_to(double phi) {
    motion_.move_to(phi);
    inertia_ = equivalent_inertia(motion_.bodies(), inertias_);
    inertia_.value += flywheel_;
    const double omega = planted(phi);
    load_ = inertia_.value * omega * planted_slope(phi) + 0.5 * inertia_.slope * omega * omega -
            motor(omega);
    return inertia_;
  }
  Torques torques(double omega) const { return {motor(omega), load_}; }

  static double motor(double omega) { return 400 - 12 * omega; }

 private:
  MechanismMotion<2> motion_;
  std::vector<Inertia> inertias_;
  double flywheel_;
  EquivalentInertia inertia_;
  double load_ = 0;
};

Machine machine_of(double flywheel) {
  auto planted = std::make_shared<Planted>(flywheel);
  return {.move_to = [planted](double phi) { return planted->move_to(phi); },
          .torques = [planted](double omega, double) { return planted->torques(omega); },
          .period = kTurn};
}

double error(const MachineState& state) {
  return std::abs(state.omega / planted(state.phi) - 1);
}

double by_shooting(double flywheel, double tolerance) {
  const Machine machine = machine_of(flywheel);
  const SteadyState steady = steady_state(machine, {}, {.relative = tolerance}, 24);
  double worst = 0;
  for (const MachineState& state : steady.states) worst = std::max(worst, error(state));
  return worst;
}

/// dω/dφ by the equation of motion.
double slope(Planted& planted, double phi, double omega) {
  const auto [inertia, inertia_slope] = planted.move_to(phi);
  return (planted.torques(omega).sum() - 0.5 * omega * omega * inertia_slope) / (inertia * omega);
}

double euler_step(Planted& planted, double phi, double omega, double step) {
  return omega + step * slope(planted, phi, omega);
}

double runge_kutta_step(Planted& planted, double phi, double omega, double step) {
  const double k1 = slope(planted, phi, omega);
  const double k2 = slope(planted, phi + step / 2, omega + step / 2 * k1);
  const double k3 = slope(planted, phi + step / 2, omega + step / 2 * k2);
  const double k4 = slope(planted, phi + step, omega + step * k3);
  return omega + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

/// Runs turns of `steps` equal steps until they repeat.
template <class Step>
double by_turns(double flywheel, int steps, Step&& step) {
  Planted planted_machine(flywheel);
  const double length = kTurn / steps;
  double omega = 18, worst = 0;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const double before = omega;
    worst = 0;
    for (int i = 0; i < steps; ++i) {
      omega = step(planted_machine, i * length, omega, length);
      worst = std::max(worst, std::abs(omega / planted((i + 1) * length) - 1));
    }
    if (std::abs(omega - before) <= kRepeats * omega) break;
  }
  return worst;
}

double in_time(double flywheel, double tolerance) {
  const Machine machine = machine_of(flywheel);
  const TorqueBreakpoints breakpoints = breakpoints_about(machine, {.speed = 18});
  MachineState state{.omega = 18};
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const double before = state.omega;
    state = {.omega = state.omega};
    state = run(machine, breakpoints, state, {.travel = kTurn}, {.relative = tolerance}, 0)
                .states.back();
    if (std::abs(state.omega - before) <= std::max(kRepeats, 0.01 * tolerance) * before) break;
  }
  const MachineRun last = run(machine, breakpoints, {.omega = state.omega}, {.travel = kTurn},
                              {.relative = tolerance}, 24);
  double worst = 0;
  for (const MachineState& at : last.states) worst = std::max(worst, error(at));
  return worst;
}

struct Method {
  std::string name;
  std::function<double(double flywheel)> error;
};

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const double tolerance : {1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13}) {
    all.push_back({fmt::format("shooting, tolerance {:.0e}", tolerance),
                   [=](double flywheel) { return by_shooting(flywheel, tolerance); }});
  }
  for (const int steps : {24, 360, 3600}) {
    all.push_back({fmt::format("Euler, steps of {}°", 360.0 / steps),
                   [=](double flywheel) { return by_turns(flywheel, steps, euler_step); }});
  }
  for (const int steps : {24, 90, 360}) {
    all.push_back({fmt::format("Runge-Kutta, steps of {}°", 360.0 / steps),
                   [=](double flywheel) { return by_turns(flywheel, steps, runge_kutta_step); }});
  }
  for (const double tolerance : {1e-6, 1e-10}) {
    all.push_back({fmt::format("in time, tolerance {:.0e}", tolerance),
                   [=](double flywheel) { return in_time(flywheel, tolerance); }});
  }
  return all;
}

void print(double flywheel) {
  const auto all = methods();
  std::vector<double> seconds(all.size(), std::numeric_limits<double>::infinity());
  std::vector<double> errors(all.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto begin = std::chrono::steady_clock::now();
      errors[i] = all[i].error(flywheel);
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
      seconds[i] = std::min(seconds[i], spent.count());
    }
  }
  const SteadyState steady = steady_state(machine_of(flywheel), {}, {}, 24);
  fmt::print("\nFlywheel {} kg m²: {:.3g} of a deviation are left after a turn\n\n", flywheel,
             steady.multiplier);
  fmt::print("| method | ms | times the first | error |\n|---|---|---|---|\n");
  for (std::size_t i = 0; i < all.size(); ++i) {
    fmt::print("| {} | {:.3f} | {:.1f} | {:.1e} |\n", all[i].name, 1e3 * seconds[i],
               seconds[i] / seconds[0], errors[i]);
  }
}

}  // namespace
}  // namespace cognate::bench

int main() {
  for (const double flywheel : {0.0, 100.0}) cognate::bench::print(flywheel);
}
