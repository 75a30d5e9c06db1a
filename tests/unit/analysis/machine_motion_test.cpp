/// Machines that run, start and stop, against closed forms and planted solutions.
#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>

#include "analysis/machine/flywheel.hpp"
#include "analysis/machine/reduction.hpp"
#include "analysis/machine/run.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/machines.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate::machine::machine_motion_test {
namespace {

using test::constant_inertia;
using test::machine_of;

double sign(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

TEST(Reduction, GivesTheTorqueOfInverseDynamics) {
  // J α + ½ ω² dJ/dφ − M of loads and weights is what the drive must give, by d'Alembert.
  test::ChainMaker maker(7);
  int compared = 0;
  for (int drive = 0; drive < 3; ++drive) {
    for (int i = 0; i < 25; ++i) {
      const Mechanism<double> mechanism = maker.make(drive, {i / 5, i % 5});
      std::vector<Inertia> inertias(static_cast<std::size_t>(body_count(mechanism)));
      for (Inertia& inertia : inertias) {
        inertia = {maker.uniform(0, 3), {maker.uniform(-1, 1), maker.uniform(-1, 1)}, 0.4};
      }
      const std::vector<Load> loads{{{2, {0.3, 0.1}}, {5, -2}, 3}, {{5, {1, 0}}, {1, 4}, -1}};
      MechanismMotion<2> motion(mechanism);
      if (!motion.move_to(test::ChainMaker::kStart)) continue;
      const auto bodies = motion.bodies();
      const Vec2d gravity{0.5, -9.8};
      const EquivalentInertia inertia = equivalent_inertia(bodies, inertias);
      const double acting = weight_torque(bodies, inertias, gravity) + load_torque(bodies, loads);
      const InverseDynamics dynamics(mechanism, inertias, gravity);
      for (const DriveRate rate : {DriveRate{0, 0}, DriveRate{2, 0}, DriveRate{-1.5, 3}}) {
        const double expected = dynamics.drive<2>(bodies, rate, loads);
        const double driving = inertia.value * rate.acceleration +
                               0.5 * rate.speed * rate.speed * inertia.slope - acting;
        EXPECT_NEAR(driving, expected, 1e-12 * (std::abs(expected) + std::abs(inertia.slope) + 1));
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 60);
}

TEST(Reduction, SlopeIsTheDerivative) {
  const Mechanism<double> mechanism{Crank<double>{{0, 0}, 1},
                                    {Rrr<double>{{1, {1, 0}}, {0, {3, 0}}, 3, 2}}};
  const std::vector<Inertia> inertias(4, Inertia{2, {0.4, 0.2}, 0.3});
  MechanismMotion<2> motion(mechanism);
  const auto inertia = [&](double phi) {
    motion.move_to(phi);
    return equivalent_inertia(motion.bodies(), inertias);
  };
  constexpr double h = 1e-3;
  for (double phi = 0.1; phi < 6.2; phi += 0.3) {
    const auto difference = [&](double step) {
      return (inertia(phi + step).value - inertia(phi - step).value) / (2 * step);
    };
    const double expected = (4 * difference(h / 2) - difference(h)) / 3;
    EXPECT_NEAR(inertia(phi).slope, expected, 1e-9);
  }
}

/// J = 3 + cos φ with a torque of 2 N m.
Machine uneven_wheel() {
  return machine_of(
      [](double phi) {
        return EquivalentInertia{3 + std::cos(phi), -std::sin(phi)};
      },
      [](double, double, double) {
        return Torques{3, -1};
      });
}

TEST(Run, KeepsTheEnergyIntegral) {
  const MachineRun start = run(uneven_wheel(), {}, {.travel = 20}, {.relative = 1e-12}, 50);
  ASSERT_EQ(start.stop, RunStop::travel);
  ASSERT_EQ(start.states.size(), 52U);
  EXPECT_EQ(start.states.back().phi, 20);
  const double step = start.states.back().time / 51;
  for (std::size_t i = 0; i < start.states.size(); ++i) {
    const auto& [time, phi, omega, motor_work, load_work] = start.states[i];
    EXPECT_NEAR(time, double(i) * step, 1e-12);
    EXPECT_NEAR(0.5 * (3 + std::cos(phi)) * omega * omega, 2 * phi, 1e-10);
    EXPECT_NEAR(motor_work, 3 * phi, 1e-10);
    EXPECT_NEAR(load_work, -phi, 1e-10);
  }
}

/// A pendulum of ω₀ = 1 about φ = 2.
Machine pendulum() {
  return machine_of(constant_inertia(1), [](double phi, double, double) {
    return Torques{0, -std::sin(phi - 2)};
  });
}

TEST(Run, TurnsRoundAsAPendulumDoes) {
  // From rest at 1 rad: a half swing takes 2 K(sin ½), ten half swings ten times that.
  const double half_swing = 2 * boost::math::ellint_1(std::sin(0.5));
  const Accuracy accuracy{.relative = 1e-12};
  const MachineState from{.phi = 3};
  const MachineRun once = run(pendulum(), from, {.at_rest = true}, accuracy, 0);
  EXPECT_EQ(once.stop, RunStop::at_rest);
  EXPECT_NEAR(once.states.back().time, half_swing, 1e-10);
  EXPECT_NEAR(once.states.back().phi, 1, 1e-10);
  const MachineRun many = run(pendulum(), from, {.time = 10 * half_swing}, accuracy, 0);
  EXPECT_EQ(many.stop, RunStop::time);
  EXPECT_NEAR(many.states.back().phi, 3, 1e-9);
  EXPECT_NEAR(many.states.back().omega, 0, 1e-9);
  // At its highest point it stands, though it would fall at the least push.
  const MachineRun standing = run(pendulum(), {.phi = 2}, {.time = 1}, accuracy, 0);
  EXPECT_EQ(standing.stop, RunStop::stalled);
}

TEST(Run, MayTurnBackwardsThroughTheTurn) {
  const Machine machine = machine_of(constant_inertia(2), [](double, double, double) {
    return Torques{0, -1};
  });
  const MachineRun back = run(machine, {.phi = 1}, {.travel = 15}, {}, 0);
  EXPECT_EQ(back.stop, RunStop::travel);
  EXPECT_EQ(back.states.back().phi, -14);
  EXPECT_NEAR(back.states.back().omega, -std::sqrt(15.0), 1e-9);
}

/// A torque of the motor and friction against the motion.
Machine rubbing(double motor, double friction) {
  return machine_of(constant_inertia(2), [=](double, double omega, double) {
    return Torques{motor, -friction * sign(omega)};
  });
}

TEST(Run, StopsByFrictionAndStaysAtRest) {
  const MachineRun stop = run(rubbing(0, 3), {.omega = 6}, {.time = 100}, {}, 0);
  EXPECT_EQ(stop.stop, RunStop::stalled);
  EXPECT_NEAR(stop.states.back().time, 4, 1e-9);
  EXPECT_NEAR(stop.states.back().phi, 12, 1e-9);
  EXPECT_EQ(stop.states.back().omega, 0);
  EXPECT_EQ(run(rubbing(2, 3), {}, {.time = 1}, {}, 0).stop, RunStop::stalled);
  // With a motor that overcomes friction the drive comes back.
  const MachineRun back = run(rubbing(4, 3), {.omega = -7}, {.time = 4}, {}, 0);
  EXPECT_EQ(back.stop, RunStop::time);
  EXPECT_NEAR(back.states.back().omega, 0.5 * 2, 1e-9);
}

TEST(Run, RestsBetweenWallsOfTorque) {
  // Friction on one side, a spring-like step on the other: smaller and smaller bounces.
  const Machine machine =
      machine_of(constant_inertia(1),
                 [](double phi, double omega, double) {
                   return Torques{0, (phi < 1 ? 5.0 : -5.0) - 1.0 * sign(omega)};
                 },
                 {1});
  const MachineRun bounces = run(machine, {.phi = 0.5}, {.time = 1000}, {}, 0);
  EXPECT_EQ(bounces.stop, RunStop::stalled);
  EXPECT_NEAR(bounces.states.back().phi, 1, 1e-6);
}

TEST(Run, WaitsForWhatDependsOnTime) {
  Machine machine = machine_of(constant_inertia(1), [](double, double, double time) {
    return Torques{std::max(0.0, time - 1), 0};
  });
  machine.depends_on_time = true;
  const MachineRun start = run(machine, {}, {.time = 3}, {}, 0);
  EXPECT_EQ(start.stop, RunStop::time);
  EXPECT_NEAR(start.states.back().omega, 2, 1e-6);
  EXPECT_EQ(run(machine, {}, {.time = 0.5}, {}, 0).stop, RunStop::time);
}

TEST(Run, PassesAJumpOfTorqueExactly) {
  // 1 N m up to 2 rad, 4 N m from there to 5 rad, in every turn.
  const Machine machine = machine_of(constant_inertia(1),
                                     [](double phi, double, double) {
                                       return Torques{2 < phi && phi < 5 ? 4.0 : 1.0, 0};
                                     },
                                     {2, 5});
  for (const double tolerance : {1e-4, 1e-10}) {
    // Constant torques are integrated exactly, however long the steps, if none crosses a jump.
    const MachineRun turns = run(machine, {}, {.travel = 4 * kPi}, {.relative = tolerance}, 0);
    EXPECT_NEAR(0.5 * std::pow(turns.states.back().omega, 2), 4 * kPi + 18, 1e-10);
  }
}

TEST(Run, EndsWhereTheMechanismOpens) {
  const Machine machine = machine_of(
      [](double phi) {
        return EquivalentInertia{phi < 2 ? 1.0 : std::nan(""), 0};
      },
      [](double, double, double) {
        return Torques{1, 0};
      });
  const MachineRun opened = run(machine, {}, {.travel = 10}, {}, 0);
  EXPECT_EQ(opened.stop, RunStop::open);
  EXPECT_NEAR(opened.states.back().phi, 2, 1e-9);
  EXPECT_EQ(steady_state(machine, {}, {}, 10).missing, NoSteadyState::open);
}

TEST(Run, GivesUpWhenAsked) {
  Accuracy accuracy;
  accuracy.most_steps = 50;
  EXPECT_EQ(run(pendulum(), {.phi = 3}, {.time = 1e9}, accuracy, 0).stop, RunStop::gave_up);
  accuracy = {.stop = [] { return true; }};
  EXPECT_EQ(run(pendulum(), {.phi = 3}, {.time = 1e9}, accuracy, 0).stop, RunStop::stopped);
}

/// ω = 10 + 2 sin φ + cos 3φ is the motion of J = 4 + cos 2φ under 200 − 12 ω and a load that
/// follows from both: dK/dφ − (200 − 12 ω).
struct Planted {
  static double omega(double phi) { return 10 + 2 * std::sin(phi) + std::cos(3 * phi); }
  static double omega_slope(double phi) { return 2 * std::cos(phi) - 3 * std::sin(3 * phi); }
  static double motor(double omega) { return 200 - 12 * omega; }

  static EquivalentInertia inertia(double phi) {
    return {4 + std::cos(2 * phi), -2 * std::sin(2 * phi)};
  }
  static double load(double phi) {
    const auto [value, slope] = inertia(phi);
    const double w = omega(phi);
    return value * w * omega_slope(phi) + 0.5 * slope * w * w - motor(w);
  }
  static Machine machine() {
    return machine_of(inertia, [](double phi, double omega, double) {
      return Torques{motor(omega), load(phi)};
    });
  }
};

TEST(SteadyState, IsThePlantedOne) {
  for (const double from : {0.0, 2.5}) {
    for (const double speed : {1.0, 10.0, 300.0}) {
      const SteadyState steady =
          steady_state(Planted::machine(), {.phi = from, .speed = speed}, {.relative = 1e-12}, 100);
      ASSERT_EQ(steady.missing, NoSteadyState::none);
      ASSERT_EQ(steady.states.size(), 101U);
      for (const MachineState& state : steady.states) {
        EXPECT_NEAR(state.omega, Planted::omega(state.phi), 1e-9);
      }
      EXPECT_NEAR(steady.states[50].phi, from + kPi, 1e-12);
      // Deviations die out as those of dδ/dt = −12 δ/J do on the way of the planted motion.
      double exponent = 0;
      constexpr int kSteps = 400;
      for (int i = 0; i < kSteps; ++i) {
        const double phi = kTurn * i / kSteps;
        exponent -= kTurn / kSteps * 12 / (Planted::inertia(phi).value * Planted::omega(phi));
      }
      EXPECT_NEAR(steady.multiplier, std::exp(exponent), 1e-8);
      EXPECT_LT(steady.energy_residual, 1e-10);
      EXPECT_LT(steady.integrations, 25);
    }
  }
}

TEST(SteadyState, ExtremesAreWhereTheSlopeVanishes) {
  // Few states are recorded; the extremes are refined all the same.
  const SteadyState steady = steady_state(Planted::machine(), {}, {.relative = 1e-12}, 3);
  EXPECT_NEAR(Planted::omega_slope(steady.greatest.phi), 0, 1e-8);
  EXPECT_NEAR(Planted::omega_slope(steady.least.phi), 0, 1e-8);
  double greatest = 0, least = 100;
  for (int i = 0; i < 100000; ++i) {
    const double omega = Planted::omega(kTurn * i / 100000);
    greatest = std::max(greatest, omega);
    least = std::min(least, omega);
  }
  EXPECT_NEAR(steady.greatest.omega, greatest, 1e-7);
  EXPECT_NEAR(steady.least.omega, least, 1e-7);
}

NoSteadyState why_none(const test::TorqueLaw& law) {
  return steady_state(machine_of(constant_inertia(1), law), {}, {}, 10).missing;
}

TEST(SteadyState, SaysWhyThereIsNone) {
  EXPECT_EQ(why_none([](double phi, double, double) {
              return Torques{5, -6 + std::sin(phi)};
            }),
            NoSteadyState::stalls);
  EXPECT_EQ(why_none([](double phi, double, double) {
              return Torques{7, -6 + std::sin(phi)};
            }),
            NoSteadyState::runs_away);
  EXPECT_EQ(why_none([](double phi, double, double) {
              return Torques{6, -6 + std::sin(phi)};
            }),
            NoSteadyState::any_speed);
  EXPECT_EQ(why_none([](double, double, double) { return Torques{}; }), NoSteadyState::any_speed);
  // Torques that drive the faster the more.
  EXPECT_EQ(why_none([](double, double omega, double) {
              return Torques{omega * omega, 1};
            }),
            NoSteadyState::runs_away);
  // The mean torques balance at 1 rad/s, but the drive has not the energy to get over the hill.
  const auto hill = [](double phi, double omega, double) {
    return Torques{1 - omega, 50 * std::sin(phi)};
  };
  EXPECT_EQ(why_none(hill), NoSteadyState::stands);
  const auto even_hill = [](double phi, double, double) { return Torques{0, -50 * std::sin(phi)}; };
  const Machine steep = machine_of(constant_inertia(1), even_hill);
  EXPECT_EQ(steady_state(steep, {.speed = 1}, {}, 10).missing, NoSteadyState::stands);
  EXPECT_EQ(steady_state(steep, {.speed = 20}, {}, 10).states.size(), 11U);
  Machine timed = machine_of(constant_inertia(1),
                             [](double, double omega, double) { return Torques{1 - omega}; });
  timed.depends_on_time = true;
  EXPECT_EQ(steady_state(timed, {}, {}, 10).missing, NoSteadyState::depends_on_time);
}

TEST(SteadyState, IsTheStableOneOfAnInductionMotor) {
  // Kloss: 2 M/(s/s_k + s_k/s), against a load of 0.8 M: balanced at slips s = ½ s_k and 2 s_k.
  const auto law = [](double, double omega, double) {
    const double slip = 1 - omega / 100, breakdown = 0.2;
    return Torques{2 * 50 / (slip / breakdown + breakdown / slip), -40};
  };
  const Machine machine = machine_of(constant_inertia(3), law);
  for (const double speed : {70.0, 85.0, 99.0}) {
    const SteadyState steady = steady_state(machine, {.speed = speed}, {}, 4);
    ASSERT_EQ(steady.missing, NoSteadyState::none) << speed;
    EXPECT_NEAR(steady.greatest.omega, 90, 1e-7);
    EXPECT_LT(steady.multiplier, 1);
  }
  // From 30 rad/s the motor does not come over its breakdown torque; the motion is found all the
  // same.
  EXPECT_NEAR(steady_state(machine, {.speed = 30}, {}, 4).greatest.omega, 90, 1e-7);
}

TEST(SteadyState, IsFoundFromAnySpeed) {
  const Machine machine = machine_of(constant_inertia(2), [](double, double omega, double) {
    return Torques{50 - 5 * omega, 0};
  });
  for (const double speed : {1e-20, 1e-3, 10.0, 1e10, 1e30}) {
    const SteadyState steady = steady_state(machine, {.speed = speed}, {}, 4);
    ASSERT_EQ(steady.missing, NoSteadyState::none) << speed;
    EXPECT_NEAR(mean_speed(steady), 10, 1e-7) << speed;
    EXPECT_LT(steady.energy_residual, 1e-8);
  }
}

TEST(SteadyState, OfAHeavyWheelIsFoundThoughItHardlyAdapts) {
  const Machine machine = machine_of(constant_inertia(1e7), [](double phi, double omega, double) {
    return Torques{100 - omega, 10 * std::sin(phi)};
  });
  const SteadyState steady = steady_state(machine, {.speed = 1}, {}, 10);
  ASSERT_EQ(steady.missing, NoSteadyState::none);
  EXPECT_NEAR(mean_speed(steady), 100, 1e-5);
  EXPECT_NEAR(fluctuation(steady), 20 / (1e7 * 100 * 100.0), 1e-14);
}

TEST(Flywheel, OfTheEnergyIntegral) {
  // ½ (J + F)(ω² − ω₀²) = 30 (1 − cos φ): with q = ω_max/ω₀ = (2 + δ)/(2 − δ), F = 120/(ω₀² (q² −
  // 1)) − J.
  const auto machine_with = [](double flywheel) {
    return machine_of(constant_inertia(0.5 + flywheel), [](double phi, double, double) {
      return Torques{0, 30 * std::sin(phi)};
    });
  };
  const double wanted = 0.02, q = (2 + wanted) / (2 - wanted);
  const Flywheel found = flywheel_for(machine_with, wanted, {.speed = 20}, {}, 10);
  ASSERT_TRUE(found.found);
  EXPECT_NEAR(found.inertia, 120 / (400 * (q * q - 1)) - 0.5, 1e-7);
  EXPECT_NEAR(fluctuation(found.steady), wanted, 1e-10);
  EXPECT_NEAR(found.greatest_excess, 60, 1e-8);
  // The textbooks' formula takes the mean speed without a flywheel for that with it.
  const double mean = 0.5 * (20 + std::sqrt(400 + 120 / 0.5));
  EXPECT_NEAR(found.approximate, 60 / (mean * mean * wanted) - 0.5, 1e-7);
}

/// J = 2 + swing cos φ, without the flywheel.
Machine with_motor(double flywheel, double swing = 1) {
  return machine_of(
      [=](double phi) {
        return EquivalentInertia{2 + swing * std::cos(phi) + flywheel, -swing * std::sin(phi)};
      },
      [](double phi, double omega, double) {
        return Torques{300 - 10 * omega, -80 * std::sin(phi) - 30};
      });
}

TEST(Flywheel, GivesTheFluctuationWanted) {
  const auto machine_with = [](double flywheel) { return with_motor(flywheel); };
  for (const double wanted : {0.1, 0.03, 1e-3}) {
    const Flywheel found = flywheel_for(machine_with, wanted, {}, {}, 10);
    ASSERT_TRUE(found.found);
    const SteadyState steady = steady_state(with_motor(found.inertia), {}, {.relative = 1e-12}, 10);
    EXPECT_NEAR(fluctuation(steady), wanted, 1e-9);
    EXPECT_LT(fluctuation(steady_state(with_motor(1.01 * found.inertia), {}, {}, 10)), wanted);
  }
}

TEST(Flywheel, IsTheTextbooksOneWhereAllIsEven) {
  // At 27 rad/s the motor balances the load, whose -80 sin φ makes an excess of 160 J.
  const auto machine_with = [](double flywheel) { return with_motor(flywheel, 0); };
  const Flywheel found = flywheel_for(machine_with, 1e-3, {}, {}, 10);
  ASSERT_TRUE(found.found);
  EXPECT_NEAR(found.greatest_excess, 160, 1e-8);
  const double mean = mean_speed(found.without);
  EXPECT_NEAR(found.approximate, 160 / (mean * mean * 1e-3) - 2, 1e-7);
  EXPECT_NEAR(found.inertia / (160 / (27 * 27 * 1e-3) - 2), 1, 1e-3);
}

TEST(Flywheel, IsNotNeededOrNotPossible) {
  const auto even_enough = [](double flywheel) { return with_motor(flywheel); };
  const Flywheel even = flywheel_for(even_enough, 1.5, {}, {}, 10);
  EXPECT_TRUE(even.found);
  EXPECT_EQ(even.inertia, 0);
  EXPECT_EQ(even.steady.states.size(), 11U);
  const auto stalling = [](double flywheel) {
    return machine_of(constant_inertia(1 + flywheel), [](double, double, double) {
      return Torques{1, -2};
    });
  };
  const Flywheel none = flywheel_for(stalling, 0.1, {}, {}, 10);
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.without.missing, NoSteadyState::stalls);
}

}  // namespace
}  // namespace cognate::machine::machine_motion_test
