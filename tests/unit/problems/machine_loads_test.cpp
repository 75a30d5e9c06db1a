/// Loads that act over short stretches, flywheels without which a machine does not run, and
/// machines that are heavily damped: against closed forms and fixed steps of Runge and Kutta that
/// end at every jump.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "analysis/machine/flywheel.hpp"
#include "analysis/machine/run.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/machine/result.hpp"
#include "problems/read.hpp"
#include "tests/support/machines.hpp"

namespace cognate::machine::machine_loads_test {
namespace {

using test::constant_inertia;
using test::machine_of;

/// What a machine's steady turn is, by classical Runge-Kutta steps of K.
struct FixedSteps {
  test::InertiaLaw inertia;
  test::TorqueLaw torques;
  std::vector<double> cuts;  ///< increasing, from 0 to 2π

  struct Turn {
    double end = 0, least = 1e300, greatest = 0;
  };

  double torque(double phi, double kinetic) const {
    return torques(phi, std::sqrt(2 * kinetic / inertia(phi).value), 0).sum();
  }

  Turn turn(double kinetic) const {
    constexpr int kSteps = 600;
    constexpr double kInside = 1e-12;
    Turn turn{kinetic};
    for (std::size_t piece = 1; piece < cuts.size(); ++piece) {
      const double from = cuts[piece - 1] + kInside, to = cuts[piece] - kInside;
      const double h = (to - from) / kSteps;
      for (int i = 0; i < kSteps; ++i) {
        const double phi = from + i * h, k = turn.end;
        const double a = torque(phi, k), b = torque(phi + h / 2, k + h / 2 * a);
        const double c = torque(phi + h / 2, k + h / 2 * b), d = torque(phi + h, k + h * c);
        turn.end += h / 6 * (a + 2 * b + 2 * c + d);
        const double omega = std::sqrt(2 * turn.end / inertia(phi + h).value);
        turn.least = std::min(turn.least, omega);
        turn.greatest = std::max(turn.greatest, omega);
      }
    }
    return turn;
  }

  /// The turn that repeats itself, between two speeds at its beginning.
  Turn steady(double slow, double fast) const {
    double low = 0.5 * inertia(0).value * slow * slow, high = 0.5 * inertia(0).value * fast * fast;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (turn(middle).end <= middle ? high : low) = middle;
    }
    return turn(0.5 * (low + high));
  }
};

void expect_steady(const FixedSteps& expected, double slow, double fast, bool knows_jumps) {
  const auto [end, least, greatest] = expected.steady(slow, fast);
  const auto breaks = knows_jumps ? expected.cuts : std::vector<double>{};
  const Machine machine = machine_of(expected.inertia, expected.torques, breaks);
  const SteadyState steady = steady_state(machine, {}, {}, 24);
  ASSERT_EQ(steady.missing, NoSteadyState::none);
  EXPECT_NEAR(steady.least.omega, least, 2e-6 * least);
  EXPECT_NEAR(steady.greatest.omega, greatest, 2e-6 * greatest);
  EXPECT_LT(steady.energy_residual, 1e-7);
}

/// A load of `torque` from `from` over `width`, against a motor of 60 − ω at 5 kg m².
FixedSteps pulse(double from, double width, double torque, double from_speed = 0) {
  const auto law = [=](double phi, double omega, double) {
    const bool acts = phi > from && phi < from + width && omega > from_speed;
    return Torques{60 - omega, acts ? torque : 0};
  };
  return {constant_inertia(5), law, {0, from, from + width, kTurn}};
}

TEST(NarrowLoad, OfAJumpIsNotJumpedOver) {
  expect_steady(pulse(2.1, 0.1, -1500), 10, 60, false);
  expect_steady(pulse(2.1, 0.003, -50000), 10, 60, false);
  expect_steady(pulse(5.3, 0.003, -50000, 3), 10, 60, false);
  expect_steady(pulse(2.1, 0.0005, -300000), 10, 60, true);
}

TEST(NarrowLoad, OfABumpIsNotJumpedOver) {
  for (const double width : {0.004, 0.02, 0.05, 0.15, 0.3}) {
    const double height = -4000 * 0.02 / width;
    const auto law = [=](double phi, double omega, double) {
      return Torques{60 - omega, height * std::exp(-std::pow((phi - 2.1) / width, 2))};
    };
    const double reach = std::min(2.0, 8 * width);
    expect_steady({constant_inertia(5), law, {0, 2.1 - reach, 2.1 + reach, kTurn}}, 10, 60, false);
  }
}

TEST(NarrowLoad, TakesItsWorkFromTheEnergy) {
  // What a constant motor gives in a turn, the load takes within its width.
  const double motor = 3, width = 0.01, load = -motor * kTurn / width;
  const Machine machine = machine_of(constant_inertia(2), [=](double phi, double, double) {
    return Torques{motor, phi > 4 && phi < 4 + width ? load : 0};
  });
  const SteadyState steady = steady_state(machine, {.speed = 10}, {}, 10);
  EXPECT_EQ(steady.missing, NoSteadyState::any_speed);
  const double swing = motor * (kTurn - width);
  EXPECT_NEAR(steady.energy_swing, swing, 1e-7);
  EXPECT_NEAR(steady.greatest.omega, std::sqrt(100 + motor * 4.0), 1e-8);
  EXPECT_NEAR(steady.motor_power, motor * steady.greatest.omega, 1e-7);
}

TEST(NarrowLoad, IsMetInTime) {
  Machine machine = machine_of(constant_inertia(1), [](double, double, double time) {
    return Torques{time > 5 && time < 5.01 ? 100.0 : 0, 0};
  });
  machine.depends_on_time = true;
  EXPECT_NEAR(run(machine, {.omega = 1}, {.time = 20}, {}, 0).states.back().omega, 2, 1e-6);
  const Machine of_angle = machine_of(constant_inertia(1), [](double phi, double, double) {
    return Torques{phi > 3 && phi < 3.003 ? 500.0 : 0, 0};
  });
  const MachineRun turns = run(of_angle, {.omega = 1}, {.travel = 8 * kPi}, {}, 0);
  EXPECT_NEAR(turns.states.back().omega, std::sqrt(1 + 2 * 4 * 1.5), 1e-8);
}

TEST(SteadyState, IsNotReportedWhereOtherStepsDisagree) {
  // A load that grows with every look at it.
  double looks = 0;
  const Machine machine = machine_of(constant_inertia(5), [&](double, double omega, double) {
    looks += 1;
    return Torques{60 - omega, -1e-6 * looks};
  });
  const SteadyState steady = steady_state(machine, {}, {.relative = 1e-8}, 10);
  EXPECT_EQ(steady.missing, NoSteadyState::unsure);
  EXPECT_TRUE(steady.states.empty());
}

TEST(SteadyState, IsTheLeastOfThoseAtWhichNothingActs) {
  // A motor that gives nothing beyond 60 rad/s, and no load: every speed beyond goes on.
  const auto law = [](double, double omega, double) { return Torques{std::max(0.0, 60 - omega)}; };
  const test::InertiaLaw uneven = [](double phi) {
    return EquivalentInertia{2 + std::cos(phi), -std::sin(phi)};
  };
  for (const double speed : {20.0, 59.0, 65.0, 200.0}) {
    const SteadyState even =
        steady_state(machine_of(constant_inertia(2), law), {.speed = speed}, {}, 10);
    ASSERT_EQ(even.missing, NoSteadyState::none);
    EXPECT_NEAR(even.least.omega, 60, 1e-6);
    const SteadyState swinging = steady_state(machine_of(uneven, law), {.speed = speed}, {}, 10);
    EXPECT_NEAR(swinging.least.omega, 60, 1e-4);
  }
  const auto never = [](double, double omega, double) { return Torques{0, omega > 5 ? -1.0 : 0}; };
  EXPECT_NEAR(mean_speed(steady_state(machine_of(constant_inertia(2), never), {.speed = 3}, {}, 4)),
              3, 1e-12);
}

TEST(SteadyState, ExtremesOfEnergyAndPowerAreNotThoseOfRows) {
  const auto motor = [](double omega) { return 300 - 10 * omega; };
  const auto inertia = [](double phi) {
    return EquivalentInertia{2 + std::cos(phi), -std::sin(phi)};
  };
  const Machine machine = machine_of(inertia, [=](double phi, double omega, double) {
    return Torques{motor(omega), -80 * std::sin(phi) - 30 - 300 * std::cos(5 * phi)};
  });
  const SteadyState few = steady_state(machine, {}, {}, 3);
  const SteadyState many = steady_state(machine, {}, {}, 20000);
  double least = 1e300, greatest = 0, power = 0;
  for (const MachineState& state : many.states) {
    const double energy = 0.5 * inertia(state.phi).value * state.omega * state.omega;
    least = std::min(least, energy);
    greatest = std::max(greatest, energy);
    power = std::max(power, motor(state.omega) * state.omega);
  }
  EXPECT_NEAR(few.energy_swing, greatest - least, 1e-6 * (greatest - least));
  EXPECT_NEAR(few.motor_power, power, 3e-8 * power);
}

/// A crank of 0.1 and a coupler of 0.45 that move a slider of 6 kg along +x.
struct Slider {
  static double at(double phi) {
    return 0.1 * std::cos(phi) + std::sqrt(0.45 * 0.45 - std::pow(0.1 * std::sin(phi), 2));
  }
  static double rate(double phi) {
    const double below = at(phi) - 0.1 * std::cos(phi);
    return -0.1 * std::sin(phi) * (1 + 0.1 * std::cos(phi) / below);
  }
  /// The crank's angle on the way forward, which ends at 0.55.
  static double angle(double x) {
    return kTurn - std::acos(std::min(1.0, (0.01 + x * x - 0.45 * 0.45) / (0.2 * x)));
  }
  static test::InertiaLaw inertia(double crank) {
    return [=](double phi) { return EquivalentInertia{crank + 6 * std::pow(rate(phi), 2), 0}; };
  }
  /// With `force` against the way forward between two places, and a motor.
  static FixedSteps pushing(double crank, double force, double from, double to,
                            const std::function<double(double)>& motor) {
    const auto law = [=](double phi, double omega, double) {
      const bool acts = rate(phi) > 0 && at(phi) > from && at(phi) < to;
      return Torques{motor(omega), acts ? -force * rate(phi) : 0};
    };
    return {inertia(crank), law, {0, kPi, angle(from), angle(to), kTurn}};
  }
};

problems::MachineResult result_of(const std::string& crank_inertia, const std::string& rest) {
  const auto problem = problems::parse_task<problems::MachineProblem>(R"(kind = "machine"
[mechanism]
type = "slider-crank"
crank = 0.1
coupler = 0.45
[[link]]
name = "slider"
mass = 6
[[link]]
name = "crank"
inertia = )" + crank_inertia + "\n" + rest);
  EXPECT_TRUE(problem.has_value());
  return problem ? problems::run_machine(*problem, {}) : problems::MachineResult{};
}

const problems::Quantity* quantity(const problems::MachineResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.quantities, name, &problems::Quantity::name);
  return found == result.quantities.end() ? nullptr : &*found;
}

double value(const problems::MachineResult& result, const std::string& name) {
  const problems::Quantity* found = quantity(result, name);
  EXPECT_NE(found, nullptr) << name;
  return found == nullptr ? std::nan("") : std::get<double>(found->value);
}

TEST(NarrowLoad, ByPlaceAndSenseOfTheBodyIsMet) {
  const auto result = result_of("0.8", R"([[load]]
on = "slider"
force = [-1, 0]
value = "s > 0.45 && s < 0.455 && v > 0 ? 10000 : 0"
[motor]
torque = "30 - 1.0*w"
)");
  EXPECT_EQ(result.status, problems::Status::solved);
  const auto [end, least, greatest] =
      Slider::pushing(0.8, 10000, 0.45, 0.455, [](double w) { return 30 - w; }).steady(5, 30);
  EXPECT_NEAR(value(result, "motor_work_J"), 10000 * 0.005, 1e-6);
  EXPECT_NEAR(value(result, "speed_min_rad_s"), least, 1e-5);
  EXPECT_NEAR(value(result, "speed_max_rad_s"), greatest, 1e-5);
}

TEST(Flywheel, IsFoundWhereTheMachineDoesNotRunWithoutOne) {
  const auto file = [](const std::string& flywheel) {
    return R"([[load]]
on = "slider"
force = [-40000, 0]
when = "advance"
stroke = [0.7, 1]
[motor]
line = {stall_torque = 600, no_load_speed = 20}
[flywheel]
)" + flywheel;
  };
  const auto result = result_of("0.8", file("fluctuation = 0.1"));
  EXPECT_EQ(result.status, problems::Status::solved);
  const double inertia = value(result, "flywheel_inertia_kg_m2");
  const auto [end, least, greatest] =
      Slider::pushing(0.8 + inertia, 40000, 0.49, 0.55, [](double w) {
        return 600 * (1 - w / 20);
      }).steady(5, 15);
  EXPECT_NEAR(2 * (greatest - least) / (greatest + least), 0.1, 2e-6);
  for (const char* name : {"flywheel_inertia_approximate_kg_m2", "greatest_excess_work_J",
                           "fluctuation_without_flywheel"}) {
    EXPECT_EQ(quantity(result, name), nullptr) << name;
  }
  const auto short_of_energy = result_of("0.8", file("inertia = 20"));
  EXPECT_EQ(short_of_energy.status, problems::Status::no_solution);
  EXPECT_NE(short_of_energy.notes.at(0).find("a larger flywheel helps"), std::string::npos);
}

TEST(Flywheel, IsNotLookedForBeyondTheTime) {
  const auto machine_with = [](double flywheel) {
    return machine_of(constant_inertia(1 + flywheel), [](double phi, double omega, double) {
      return Torques{300 - 10 * omega, -80 * std::sin(phi)};
    });
  };
  const Accuracy accuracy{.most_steps = 10};
  EXPECT_TRUE(std::isnan(greatest_excess_work(machine_with(0), 0, 20, accuracy)));
  const Flywheel found = flywheel_for(machine_with, 0.01, {}, accuracy, 10);
  EXPECT_FALSE(found.found);
  EXPECT_EQ(found.why, NoSteadyState::gave_up);
}

/// A motor line against a load.
struct Damped {
  double inertia, load, stall_torque, no_load_speed;
};

class DampedMachine : public ::testing::TestWithParam<Damped> {};
INSTANTIATE_TEST_SUITE_P(Slow, DampedMachine,
                         ::testing::Values(Damped{10, -1, 10, 1e-4},
                                           Damped{1e-6, -1e-3, 1e-2, 1e-4},
                                           Damped{0.5, -1000, 2000, 0.02},
                                           Damped{1e30, -1e29, 1e30, 1e10},
                                           Damped{1e-20, -1, 3, 1e-15}));

TEST_P(DampedMachine, RunsWhereMotorAndLoadBalance) {
  const auto [inertia, load, stall, no_load] = GetParam();
  const auto law = [=, load = load, stall = stall, no_load = no_load](double, double omega,
                                                                      double) {
    return Torques{stall * (1 - omega / no_load), load};
  };
  const SteadyState steady = steady_state(machine_of(constant_inertia(inertia), law), {}, {}, 10);
  ASSERT_EQ(steady.missing, NoSteadyState::none);
  const double expected = no_load * (1 + load / stall);
  EXPECT_NEAR(steady.greatest.omega, expected, 1e-9 * expected);
  EXPECT_NEAR(steady.least.omega, expected, 1e-9 * expected);
}

TEST(DampedMachine, FollowsItsLoadAtOnce) {
  // What J leaves of ω(φ) = ω₀ (1 + load/stall torque) is of the order of J ω₀ dω/dφ over the
  // motor's slope.
  for (const double no_load : {0.1, 1.0}) {
    const auto law = [=](double phi, double omega, double) {
      return Torques{2000 * (1 - omega / no_load), -1000 * (1 + 0.2 * std::sin(phi))};
    };
    const SteadyState steady = steady_state(machine_of(constant_inertia(0.01), law), {}, {}, 24);
    ASSERT_EQ(steady.missing, NoSteadyState::none);
    for (const MachineState& state : steady.states) {
      const double expected = no_load * (0.5 - 0.1 * std::sin(state.phi));
      EXPECT_NEAR(state.omega, expected, 1e-6 * no_load);
    }
    EXPECT_NEAR(steady.multiplier, 0, 1e-12);
    EXPECT_LT(steady.energy_residual, 1e-7);
  }
}

TEST(Run, MayTakeMoreStepsTheFartherItGets) {
  const Machine machine = machine_of(constant_inertia(1),
                                     [](double phi, double, double) {
                                       return Torques{std::sin(phi), 0};
                                     },
                                     {1, 2, 3});
  const Accuracy accuracy{.most_steps = 500};
  EXPECT_EQ(run(machine, {.omega = 3}, {.travel = 500}, accuracy, 0).stop, RunStop::travel);
  // So far on, φ does not decide on which side of a break the drive is.
  for (const double from : {1e5, 3e5, 1e6, 2e6}) {
    const MachineRun far = run(machine, {.phi = from, .omega = 3}, {.travel = 20}, {}, 0);
    EXPECT_EQ(far.stop, RunStop::travel);
    EXPECT_NEAR(far.states.back().phi, from + 20, 1e-9);
  }
}

}  // namespace
}  // namespace cognate::machine::machine_loads_test
