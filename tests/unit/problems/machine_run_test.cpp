/// What the machine of a file does: its reduction, its loads with their jumps, what is reported of
/// it.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/machine/cycle.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/machine/model.hpp"
#include "tests/support/count_allocations.hpp"
#include "tests/support/machine_results.hpp"

namespace cognate::problems::machine_run_test {
namespace {

using test::column, test::quantity, test::parse, test::result_of, test::says;

/// A press with its stroke along +x, crank 0.1, coupler 0.45.
const std::string kPress = R"(
gravity = [0, -9.80665]
mechanism = {type = "slider-crank", pivot = [0, 0], crank = 0.1, coupler = 0.45}
motor = {line = {stall_torque = 900, no_load_speed = 157.08}, ratio = 20, efficiency = 0.92, inertia = 0.05}
[[link]]
name = "crank"
inertia = 0.8
[[link]]
name = "coupler"
mass = 18
centre = [0.2, 0.03]
inertia = 0.4
[[link]]
name = "slider"
mass = 60
[[load]]
on = "slider"
force = [-40000, 0]
when = "advance"
stroke = [0.7, 1]
)";

TEST(MachineModel, ReducesAsInverseDynamicsDoes) {
  const MachineProblem problem = parse(kPress);
  const Deadline deadline{problems::Run{}};
  const MachineModel model(problem, deadline);
  EXPECT_TRUE(model.turns());
  const machine::Machine machine = model.machine({.flywheel = 5});
  const AnalysisProblem& analysis = *problem.mechanism;
  const auto& mechanism = analysis.mechanism.mechanism;
  const InverseDynamics dynamics(mechanism, analysis.inertias, analysis.gravity);
  MechanismMotion<2> motion(mechanism);
  const Stroke stroke{0.35, 0.55};
  ActiveLoads active(mechanism, analysis.loads, {&stroke, 1});
  for (double phi = 0.05; phi < kTurn; phi += 0.1) {
    motion.move_to(phi);
    const auto [inertia, slope] = machine.move_to(phi);
    for (const double omega : {3.0, -3.0}) {
      const auto loads = active.at<2>(phi, omega, motion.bodies());
      const double at_rest = dynamics.drive<2>(motion.bodies(), {}, loads);
      EXPECT_NEAR(machine.torques(omega, 0).load, -at_rest, 1e-10 * (std::abs(at_rest) + 1));
      const double moved = dynamics.drive<2>(motion.bodies(), {omega, 7}, loads) - at_rest;
      const double constant = 5 + 0.05 * 400;
      EXPECT_NEAR((inertia - constant) * 7 + 0.5 * omega * omega * slope, moved, 1e-10);
      const double motor = 20 * 900 * (1 - 20 * omega / 157.08);
      const double share = motor * omega > 0 ? 0.92 : 1 / 0.92;
      EXPECT_NEAR(machine.torques(omega, 0).motor, share * motor, 1e-9);
    }
  }
}

TEST(MachineModel, KnowsWhereLoadsBeginAndCease) {
  const MachineProblem problem = parse(kPress);
  const Deadline deadline{problems::Run{}};
  const machine::Machine machine = MachineModel(problem, deadline).machine({});
  // Dead centres, and where 0.7 of the stroke from 0.35 to 0.55 are done on either way.
  const double x = 0.35 + 0.7 * 0.2;
  const double angle = std::acos((0.01 + x * x - 0.45 * 0.45) / (0.2 * x));
  std::vector<double> expected{0, angle, kPi, kTurn - angle};
  for (const double place : expected) {
    EXPECT_TRUE(std::ranges::any_of(machine.breaks, [&](double found) {
      return std::abs(std::remainder(found - place, kTurn)) < 1e-12;
    })) << place;
  }
  const auto load = [&](double phi) {
    machine.move_to(phi);
    return machine.torques(1, 0).load;
  };
  const double begin = kTurn - angle;
  EXPECT_GT(std::abs(load(begin + 1e-9) - load(begin - 1e-9)), 1000);
}

TEST(MachineModel, AllocatesNothingWhileItTurns) {
  const MachineProblem problem = parse(kPress + R"(
[[load]]
on = "slider"
force = [-1, 0]
value = "50*v"
)");
  const Deadline deadline{problems::Run{}};
  const machine::Machine machine = MachineModel(problem, deadline).machine({.flywheel = 50});
  const machine::TorqueBreakpoints breakpoints(machine);
  machine::Cycle cycle(machine, breakpoints, 0.3, 1000, {});
  ASSERT_EQ(cycle.run(1000), machine::CycleEnd::whole);
  const std::size_t before = test::allocations();
  EXPECT_EQ(cycle.run(1100), machine::CycleEnd::whole);
  EXPECT_EQ(test::allocations(), before);
}

TEST(RunMachine, BalancesTheWorkOfItsLoads) {
  // 40 kN over 0.3 of 0.2 m are 2400 J in a turn, at any speed; weights do no work in a turn.
  const MachineResult result = result_of(kPress + "[flywheel]\ninertia = 20\n");
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_NEAR(quantity(result, "motor_work_J"), 2400, 1e-5);
  EXPECT_LT(quantity(result, "energy_residual"), 1e-9);
  EXPECT_NEAR(quantity(result, "motor_power_mean_W"), 2400 / quantity(result, "period_s"), 1e-3);
  const MachineMotion& motion = result.motions.at(0);
  const auto& speeds = column(motion, "speed_rad_s");
  ASSERT_EQ(speeds.size(), 361U);
  EXPECT_EQ(column(motion, "crank_deg")[90], 90);
  EXPECT_LE(*std::ranges::max_element(speeds), quantity(result, "speed_max_rad_s"));
  EXPECT_GE(*std::ranges::min_element(speeds), quantity(result, "speed_min_rad_s"));
  EXPECT_NEAR(speeds.front(), speeds.back(), 1e-8);
  // The table's energies agree with its works, and its accelerations with its speeds.
  const auto& energy = column(motion, "kinetic_energy_J");
  const auto& excess = column(motion, "excess_work_J");
  const auto& acceleration = column(motion, "acceleration_rad_s2");
  const auto& time = column(motion, "time_s");
  for (std::size_t i = 2; i < 358; ++i) {
    EXPECT_NEAR(energy[i] - energy[0], excess[i], 1e-5);
    if (i > 120) continue;  // short of the load's jump
    const double slope = (speeds[i + 1] - speeds[i - 1]) / (time[i + 1] - time[i - 1]);
    EXPECT_NEAR(acceleration[i], slope, 0.02 * std::abs(slope) + 0.2);
  }
}

TEST(RunMachine, FindsTheFlywheelAndReportsTheTextbooksOne) {
  const MachineResult result = result_of(kPress + "[flywheel]\nfluctuation = 0.1\n");
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_NEAR(quantity(result, "fluctuation"), 0.1, 1e-8);
  EXPECT_GT(quantity(result, "fluctuation_without_flywheel"), 0.1);
  EXPECT_GT(quantity(result, "flywheel_inertia_approximate_kg_m2"), 0);
  const std::string found = std::to_string(quantity(result, "flywheel_inertia_kg_m2"));
  const MachineResult with = result_of(kPress + "[flywheel]\ninertia = " + found + "\n");
  EXPECT_NEAR(quantity(with, "fluctuation"), 0.1, 1e-6);
}

TEST(RunMachine, StartsAndStops) {
  // J = 4, M = 40 − 5 ω: ω = 8 (1 − e^(−5t/4)), 1 % short of 8 after (4/5) ln 100; and the
  // brake of 6 N m stops 8 rad/s in 16/3 s, with 64/3 rad.
  const MachineResult result = result_of(R"(
equivalent = {inertia = 4}
motor = {torque = "40 - 5*w"}
brake = {torque = 6}
run = {tasks = ["start", "stop", "steady"]}
)");
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.motions.size(), 3U);
  EXPECT_NEAR(quantity(result, "speed_mean_rad_s"), 8, 1e-8);
  EXPECT_NEAR(quantity(result, "start_time_s"), 0.8 * std::log(100), 1e-8);
  EXPECT_NEAR(quantity(result, "start_end_speed_rad_s"),
              8 * (1 - std::exp(-1.25 * quantity(result, "start_time_s"))), 1e-8);
  EXPECT_NEAR(quantity(result, "stop_time_s"), 16.0 / 3, 1e-7);
  EXPECT_NEAR(quantity(result, "stop_turns"), 64.0 / 3 / (kTurn), 1e-7);
  EXPECT_EQ(column(result.motions[1], "speed_rad_s").back(), 0);
  EXPECT_EQ(column(result.motions[0], "time_s").size(), 361U);
}

TEST(RunMachine, SaysWhatCannotBe) {
  const MachineResult beyond = result_of(R"(
equivalent = {inertia = 10}
motor = {torque = "26500 - 264*w"}
[run]
tasks = ["start"]
speed_end = 110
)");
  EXPECT_EQ(beyond.status, Status::infeasible);
  EXPECT_TRUE(says(beyond, "the speed does not reach 110 rad/s: it settles"));
  const MachineResult stalls = result_of(R"(
equivalent = {inertia = 10, torque = -5}
motor = {torque = 4}
[run]
tasks = ["steady", "start", "stop"]
)");
  EXPECT_NE(stalls.status, Status::solved);
  EXPECT_TRUE(says(stalls, "the machine stalls"));
  EXPECT_TRUE(says(stalls, "the stop has no speed to begin from"));
  const MachineResult rubs = result_of(R"(
equivalent = {inertia = 10, torque = "w > 0 ? -5 : w < 0 ? 5 : 0"}
motor = {torque = 4}
[run]
tasks = ["start"]
)");
  EXPECT_TRUE(says(rubs, "stands still and nothing moves it"));
  const MachineResult valueless = result_of(R"(
equivalent = {inertia = 10}
motor = {torque = 'log(-1 - w)'}
)");
  EXPECT_TRUE(says(valueless, "no value"));
  EXPECT_EQ(valueless.status, Status::no_solution);
  EXPECT_TRUE(says(result_of("equivalent = {inertia = 10}\nmotor = {torque = \"5 - w + t\"}\n"),
                   "depend on time"));
  const MachineResult coasts = result_of(R"(
equivalent = {inertia = 10}
motor = {torque = "5 - w"}
[run]
tasks = ["stop"]
)");
  EXPECT_TRUE(says(coasts, "the stop ended at its limit, after"));
}

TEST(RunMachine, NeedsInertiaEverywhere) {
  // The slider alone has mass, and stands still at its dead centres.
  const MachineResult result = result_of(R"(
mechanism = {type = "slider-crank", pivot = [0, 0], crank = 0.1, coupler = 0.45, offset = 0.03}
motor = {torque = "5 - w"}
[[link]]
name = "slider"
mass = 5
)");
  EXPECT_EQ(result.status, Status::no_solution);
  EXPECT_TRUE(says(result, "the machine's inertia vanishes where the drive is at"));
}

TEST(RunMachine, OfARockingDriveHasNoSteadyState) {
  const std::string rocker = R"(
mechanism = {type = "four-bar", fixed_pivots = [[0, 0], [2, 0]], crank = 2, coupler = 1, rocker = 2}
motor = {torque = "5 - w"}
[[link]]
name = "rocker"
mass = 2
centre = [1, 0]
[run]
start_deg = 20
tasks = ["steady", "start"]
)";
  const MachineResult result = result_of(rocker);
  EXPECT_NE(result.status, Status::solved);
  EXPECT_TRUE(says(result, "the drive cannot turn fully"));
}

/// With a motor, and masses on coupler and rocker.
std::string four_bar(const std::string& lengths, const std::string& start_deg) {
  return "mechanism = {type = \"four-bar\", " + lengths + "}\n" + R"(
motor = {torque = "50 - 5*w"}
[[link]]
name = "coupler"
mass = 2
centre = [1, 0.5]
[[link]]
name = "rocker"
inertia = 3
[run]
tolerance = 1e-8
start_deg = )" +
         start_deg;
}

// The pivots B and D must be no farther apart than 3.5, no nearer than 0.5; BD² = 8 − 8 cos φ.
TEST(RunMachine, OfATripleRockerEndsWhereTheLinksAreInLine) {
  const MachineResult result = result_of(R"(
mechanism = {type = "four-bar", fixed_pivots = [[0, 0], [2, 0]], crank = 2, coupler = 1.5, rocker = 2}
link = [{name = "rocker", inertia = 2}]
motor = {line = {stall_torque = 20, no_load_speed = 10}}
run = {tasks = ["start"], start_deg = 30})");
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_NEAR(360 * quantity(result, "start_turns"), std::acos(1 - 12.25 / 8) * 180 / kPi - 30,
              1e-6);
  EXPECT_TRUE(says(result, "the mechanism cannot be assembled further on"));
  EXPECT_LT(result.work.positions, 100'000u);
}

TEST(RunMachine, OfAChangePointLinkageRepeatsAfterTwoTurns) {
  // At 180° its links lie in one line, and it goes on in the other assembly.
  const MachineResult result = result_of(
      four_bar("fixed_pivots = [[0, 0], [4, 0]], crank = 1, coupler = 2, rocker = 3", "30"));
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.motions.size(), 1U);
  EXPECT_NEAR(column(result.motions[0], "crank_deg").back(), 30 + 720, 1e-9);
  EXPECT_LT(quantity(result, "energy_residual"), 1e-6);
}

TEST(RunMachine, OfAParallelogramRepeatsAfterOneThoughItStartsAtAChangePoint) {
  for (const char* start : {"0", "30"}) {
    const MachineResult result = result_of(
        four_bar("fixed_pivots = [[0, 0], [3, 0]], crank = 1, coupler = 3, rocker = 1", start));
    EXPECT_EQ(result.status, Status::solved);
    // Its coupler does not turn: J is 2 + 3 kg m² all round, and the speed is even.
    EXPECT_NEAR(quantity(result, "period_s"), kTurn / 10, 1e-8);
    EXPECT_NEAR(quantity(result, "speed_max_rad_s"), 10, 1e-7);
    EXPECT_NEAR(column(result.motions.at(0), "inertia_kg_m2")[50], 5, 1e-9);
  }
}

TEST(RunMachine, EndsWhenItsTimeIsUp) {
  problems::Run run;
  run.time_limit = 0;
  EXPECT_EQ(run_machine(parse(kPress), run).status, Status::time_limit);
  std::atomic<bool> stop = true;
  run = {.interrupted = &stop};
  EXPECT_EQ(run_machine(parse(kPress), run).status, Status::interrupted);
}

}  // namespace
}  // namespace cognate::problems::machine_run_test
