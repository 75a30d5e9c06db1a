/// The moment at which a start ends, against closed forms and against an integration that shares
/// no code with the program.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "analysis/numbers/constants.hpp"
#include "tests/support/machine_results.hpp"

namespace cognate::problems::machine_start_test {
namespace {

using test::quantity, test::result_of;

/// J ω̇ = stall (1 − ω/no_load) + load, from rest: ω = ω_s (1 − e^(−t/τ)), τ = J no_load/stall.
struct LineStart {
  double inertia, stall, no_load, load;

  double settles_at() const { return no_load * (1 + load / stall); }
  double time_to(double share) const { return -inertia * no_load / stall * std::log(1 - share); }
  std::string file(const std::string& more) const {
    std::ostringstream text;
    text.precision(17);
    text << "equivalent = {inertia = " << inertia << ", torque = " << load << "}\n"
         << "motor = {line = {stall_torque = " << stall << ", no_load_speed = " << no_load << "}}\n"
         << "[run]\ntasks = [\"start\"]\nsteps = 12\nturns_max = 1e6\n"
         << more;
    return text.str();
  }
};

TEST(MachineStart, OfAFastMachineEndsWithinItsFirstTurn) {
  const LineStart fast{0.02, 200, 15, -20};
  EXPECT_NEAR(quantity(result_of(fast.file("")), "start_time_s"), fast.time_to(0.99), 1e-9);
}

TEST(MachineStart, OfALineEndsAsItsClosedFormDoes) {
  std::mt19937_64 random(3);
  const auto between = [&](double a, double b) {
    return std::exp(std::uniform_real_distribution(std::log(a), std::log(b))(random));
  };
  int within_a_turn = 0, counted = 0;
  for (int i = 0; i < 50; ++i) {
    LineStart start{between(1e-3, 10), between(1, 1000), between(1, 300), 0};
    start.load = -start.stall * std::uniform_real_distribution(0.0, 0.9)(random);
    const double to_steady = start.time_to(0.99);
    const MachineResult settled = result_of(start.file(""));
    EXPECT_NEAR(quantity(settled, "start_time_s"), to_steady, 1e-6 * to_steady) << start.file("");
    EXPECT_NEAR(quantity(settled, "start_end_speed_rad_s"), 0.99 * start.settles_at(),
                1e-7 * start.settles_at());
    within_a_turn += quantity(settled, "start_turns") < 1;
    const double share = std::uniform_real_distribution(0.05, 0.95)(random);
    std::ostringstream end;
    end.precision(17);
    end << "speed_end = " << share * start.settles_at() << "\n";
    const double to_speed = start.time_to(share);
    EXPECT_NEAR(quantity(result_of(start.file(end.str())), "start_time_s"), to_speed,
                1e-6 * to_speed);
    ++counted;
  }
  EXPECT_EQ(counted, 50);
  EXPECT_GT(within_a_turn, 5);
}

TEST(MachineStart, ThatIsSteadyFromTheBeginningTakesNoTime) {
  const LineStart start{0.1, 10, 20, -2};
  EXPECT_EQ(quantity(result_of(start.file("start_speed = 16.01\n")), "start_time_s"), 0);
  // From above: 25 = 16 + 9, and 9 e^(−t/τ) is 0.16.
  EXPECT_NEAR(quantity(result_of(start.file("start_speed = 25\n")), "start_time_s"),
              0.2 * std::log(9 / 0.16), 1e-7);
}

/// ω̇ of a machine of inertia J with a motor line and a load that goes with the angle.
struct UnevenMachine {
  double inertia, stall, no_load, even, uneven;

  double rate(double phi, double omega) const {
    return (stall * (1 - omega / no_load) - even - uneven * std::sin(phi)) / inertia;
  }
  std::string file() const {
    std::ostringstream text;
    text.precision(17);
    text << "equivalent = {inertia = " << inertia << ", torque = \"-" << even << " - " << uneven
         << "*sin(phi)\"}\nmotor = {line = {stall_torque = " << stall
         << ", no_load_speed = " << no_load << "}}\n[run]\ntasks = [\"start\"]\nsteps = 12\n";
    return text.str();
  }
};

/// The classical Runge–Kutta step of dy/dx = f(x, y).
template <class Function>
double runge_kutta(const Function& f, double x, double y, double h) {
  const double k1 = f(x, y), k2 = f(x + h / 2, y + h / 2 * k1), k3 = f(x + h / 2, y + h / 2 * k2);
  return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + f(x + h, y + h * k3));
}

/// The time until the speed is within 1 % of the steady one, both followed by the angle: the steady
/// one as what is left after many turns.
double time_of_start(const UnevenMachine& machine) {
  constexpr int kCells = 20000, kTurns = 60;
  constexpr double kStep = kTurn / kCells;
  const auto by_angle = [&](double phi, double omega) { return machine.rate(phi, omega) / omega; };
  std::vector<double> steady(kCells + 1, machine.no_load);
  for (int turn = 0; turn < kTurns; ++turn) {
    steady[0] = steady[kCells];
    for (int i = 0; i < kCells; ++i)
      steady[i + 1] = runge_kutta(by_angle, kStep * i, steady[i], kStep);
  }
  const auto steady_at = [&](double phi) {
    const double cell = std::fmod(phi, kTurn) / kStep;
    const int i = std::min(static_cast<int>(cell), kCells - 1);
    return std::lerp(steady[i], steady[i + 1], cell - i);
  };
  double phi = 0, omega = 0, time = 0, before = 1;
  const double h = 1e-4 * machine.inertia * machine.no_load / machine.stall;
  while (true) {
    const double speed = omega;
    omega = runge_kutta([&](double t, double w) { return machine.rate(phi + t * speed, w); }, 0,
                        omega, h);
    phi += h * (speed + omega) / 2;
    time += h;
    const double short_of = 1 - omega / steady_at(phi) - 0.01;
    if (short_of <= 0) return time - h * short_of / (short_of - before);
    before = short_of;
  }
}

TEST(MachineStart, OfAnUnevenMachineEndsWhereItMeetsTheSteadyMotion) {
  std::mt19937_64 random(5);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution(a, b)(random);
  };
  int counted = 0;
  for (int i = 0; i < 20; ++i) {
    UnevenMachine machine{between(0.01, 0.5), 100, between(10, 40), between(0, 30), 0};
    machine.uneven = between(5, 30);
    const double time = time_of_start(machine);
    EXPECT_NEAR(quantity(result_of(machine.file()), "start_time_s"), time, 1e-4 * time)
        << machine.file();
    ++counted;
  }
  EXPECT_EQ(counted, 20);
}

}  // namespace
}  // namespace cognate::problems::machine_start_test
