/// Machines from their files: values, functions, and every fault at its place.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/read.hpp"
#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::machine_problem_test {
namespace {

const std::string kCrank =
    "kind = \"machine\"\n[mechanism]\ntype = \"slider-crank\"\npivot = [0, 0]\ncrank = 1\n"
    "coupler = 3\n[[link]]\nname = \"slider\"\nmass = 2\n";

// The first of `lines` is line 10.
std::string of_crank(const std::string& lines) {
  return kCrank + lines;
}

// The first of `lines`, keys of [equivalent], is line 3.
std::string equivalent(const std::string& lines) {
  return "kind = \"machine\"\n[equivalent]\n" + lines;
}

MachineProblem read_sound(const std::string& text) {
  auto problem = parse_task<MachineProblem>(text);
  if (!problem) ADD_FAILURE() << problem.error().front().message;
  return problem ? *std::move(problem) : MachineProblem{};
}

TEST(MachineProblem, HasEveryKeyOfItsFile) {
  const auto problem = read_sound(of_crank(R"(
[[load]]
on = "slider"
force = [-3, 0]
[[load]]
on = "slider"
force = [1, 0]
value = "2*s + 5*v + phi + 10*w + 100*t"
[equivalent]
inertia = 4
torque = -7
[motor]
line = {stall_torque = 12, no_load_speed = 30}
ratio = 5
efficiency = 0.9
inertia = 0.01
[flywheel]
fluctuation = 0.05
[brake]
torque = 6
[run]
tasks = ["stop", "steady"]
start_deg = 90
start_speed = 2
time_max = 8
turns_max = 9
speed_end = 10
steps = 24
tolerance = 1e-8
)"));
  ASSERT_TRUE(problem.mechanism && problem.motor && problem.inertia && problem.torque);
  EXPECT_EQ(problem.mechanism->loads.size(), 1u);
  EXPECT_EQ(problem.mechanism->inertias[3].mass, 2);
  ASSERT_EQ(problem.loads.size(), 1u);
  EXPECT_EQ(problem.loads[0].rule.force.x, 1);
  EXPECT_TRUE(problem.loads[0].value.of_phi && problem.loads[0].value.of_speed &&
              problem.loads[0].value.of_time);
  EXPECT_NEAR(problem.loads[0].of_travel(1, 2, 3, 4, 5), 2 * 4 + 5 * 5 + 1 + 10 * 2 + 100 * 3,
              1e-12);
  EXPECT_EQ(problem.inertia->value(1, 2, 3), 4);
  EXPECT_EQ(problem.inertia->slope(1), 0);
  EXPECT_EQ(problem.torque->value(1, 2, 3), -7);
  EXPECT_EQ(problem.motor->line->stall_torque, 12);
  EXPECT_EQ(problem.motor->torque.value(0, 0, 0), 12);
  EXPECT_NEAR(problem.motor->torque.value(0, 45, 0), -6, 1e-14) << "goes on beyond";
  EXPECT_EQ(problem.motor->ratio, 5);
  EXPECT_EQ(problem.motor->efficiency, 0.9);
  EXPECT_EQ(problem.motor->inertia, 0.01);
  EXPECT_EQ(problem.fluctuation, 0.05);
  EXPECT_EQ(problem.brake, 6);
  EXPECT_EQ(problem.run.tasks, (std::vector{MachineTask::stop, MachineTask::steady}));
  EXPECT_NEAR(problem.run.start_phi, kRightAngle, 1e-15);
  EXPECT_EQ(problem.run.start_speed, 2);
  EXPECT_EQ(problem.run.time_max, 8);
  EXPECT_EQ(problem.run.turns_max, 9);
  EXPECT_EQ(problem.run.speed_end, 10);
  EXPECT_EQ(problem.run.steps, 24);
  EXPECT_EQ(problem.run.tolerance, 1e-8);
}

TEST(MachineProblem, ATableOfStraightLinesGoesRoundTheTurn) {
  const auto problem =
      read_sound(equivalent("inertia = 1\ntorque = [[30, 10], [90, 40], [270, -20]]\n"));
  const auto torque = [&](double deg) { return problem.torque->value(deg * kDegree, 0, 0); };
  EXPECT_NEAR(torque(60), 25, 1e-12);
  EXPECT_NEAR(torque(60 + 5 * 360), 25, 1e-10);
  EXPECT_NEAR(torque(180), 10, 1e-12);
  EXPECT_NEAR(torque(330), -5, 1e-12) << "between the last row and the first of the next turn";
  EXPECT_NEAR(torque(-30), -5, 1e-12);
  EXPECT_NEAR(torque(0), 2.5, 1e-12);
  EXPECT_NEAR(problem.torque->slope(1), 30 / (60 * kDegree), 1e-12);
  ASSERT_EQ(problem.torque->breaks.size(), 3u);
  EXPECT_NEAR(problem.torque->breaks[2], 270 * kDegree, 1e-15);
}

TEST(MachineProblem, AClosingRowSaysTheFirstOneAgain) {
  const auto with = read_sound(equivalent("inertia = [[0, 3], [120, 5], [360, 3]]\n"));
  const auto without = read_sound(equivalent("inertia = [[0, 3], [120, 5]]\n"));
  EXPECT_EQ(with.inertia->breaks.size(), 2u);
  for (double phi = -7; phi < 7; phi += 0.1) {
    EXPECT_EQ(with.inertia->value(phi, 0, 0), without.inertia->value(phi, 0, 0));
  }
}

TEST(MachineProblem, ASmoothTableGoesThroughItsRowsWithoutCorners) {
  const auto problem = read_sound(
      equivalent("inertia = [[10, 3], [80, 5], [200, 4], [300, 6]]\ninterpolation = \"smooth\"\n"));
  const auto& inertia = *problem.inertia;
  for (const auto& [deg, value] : inertia.table) {
    const double phi = deg * kDegree;
    EXPECT_NEAR(inertia.value(phi, 0, 0), value, 1e-12);
    EXPECT_NEAR(inertia.slope(phi - 1e-9), inertia.slope(phi + 1e-9), 1e-6);
  }
  for (double phi = 0.05; phi < kTurn; phi += 0.1) {
    const double step = 1e-6;
    const double by_difference =
        (inertia.value(phi + step, 0, 0) - inertia.value(phi - step, 0, 0)) / (2 * step);
    EXPECT_NEAR(inertia.slope(phi), by_difference, 1e-6);
    EXPECT_GE(inertia.value(phi, 0, 0), 3 - 1e-12) << "no row is overshot";
    EXPECT_LE(inertia.value(phi, 0, 0), 6 + 1e-12);
  }
}

TEST(MachineProblem, AnExpressionBeginsAnewWithEachTurn) {
  const auto problem =
      read_sound(equivalent("inertia = \"3 + cos(2*phi)\"\ntorque = \"phi < 2 ? -1 : 3\"\n"));
  for (double phi = -9; phi < 9; phi += 0.3) {
    EXPECT_NEAR(problem.inertia->value(phi, 0, 0), 3 + std::cos(2 * phi), 1e-12);
    EXPECT_NEAR(problem.inertia->slope(phi), -2 * std::sin(2 * phi), 1e-10);
  }
  EXPECT_EQ(problem.torque->value(1 - kTurn, 0, 0), -1);
  ASSERT_EQ(problem.torque->breaks.size(), 2u);
  EXPECT_EQ(problem.torque->breaks[0], 0);
  EXPECT_NEAR(problem.torque->breaks[1], 2, 1e-14);
  EXPECT_TRUE(problem.torque->of_phi);
  EXPECT_FALSE(problem.torque->of_speed || problem.torque->of_time);
}

TEST(MachineProblem, AnExpressionsJumpsAreFoundWhateverElseItAsksFor) {
  const auto breaks = [](const std::string& torque) {
    return read_sound(equivalent("inertia = 1\ntorque = \"" + torque + "\"\n")).torque->breaks;
  };
  const auto expect = [](const std::vector<double>& found, const std::vector<double>& wanted) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-14);
  };
  expect(breaks("w > 3 && phi > 2.15 && phi < 2.25 ? -5000 : 0"), {2.15, 2.25});
  expect(breaks("w < -250 && phi > 1 && phi < 2 ? -5 : 0"), {1, 2});
  expect(breaks("w > 41 && w < 42 && phi > 1 && phi < 2 ? -5 : 0"), {1, 2});
  expect(breaks("t > 5e-3 && t < 6e-3 && phi > 1 && phi < 2 ? -5 : 0"), {1, 2});
  expect(breaks("t > 5 && w > 6 && phi > 1 && phi < 2 ? -5 : 0"), {1, 2});
  expect(breaks("phi > 2.1 && phi < 2.103 ? -50000 : 0"), {2.1, 2.103});
  expect(breaks("w > 3 ? sin(phi)*w : 0"), {});
  const auto of_travel = read_sound(
      of_crank("[[load]]\non = \"slider\"\nforce = [1, 0]\n"
               "value = \"v > 0 && s > 0.2 && s < 0.3 && phi > 1 && phi < 2 ? 1 : 0\"\n"));
  expect(of_travel.loads.at(0).value.breaks, {1, 2});
}

TEST(MachineProblem, AnExpressionsSlopeIsThatOfItsNarrowestBumps) {
  for (const double width : {0.3, 0.1, 0.03, 0.004, 0.001}) {
    const auto problem = read_sound(
        equivalent("inertia = \"2 + 5*exp(-((phi - 2)/" + std::to_string(width) + ")^2)\"\n"));
    for (double steps = -6; steps < 6; steps += 0.0137) {
      const double exact = -10 * steps / width * std::exp(-steps * steps);
      EXPECT_NEAR(problem.inertia->slope(2 + steps * width), exact, 1e-9 / width);
    }
    EXPECT_NEAR(problem.inertia->slope(4.5), 0, 1e-9);
  }
}

TEST(MachineProblem, RowsMayBeAsCloseAsIsWanted) {
  for (const std::string at : {"7", "90", "359"}) {
    read_sound(equivalent(fmt::format("inertia = [[0, 1], [{0}, 2], [{0}.000001, 3]]\n", at)));
  }
}

TEST(MachineProblem, AMotorsTableIsConstantBeyondItsEnds) {
  const std::string table = "inertia = 1\n[motor]\ntable = [[-10, 8], [50, 20], [60, 0]]\n";
  const auto straight = read_sound(equivalent(table));
  const auto smooth = read_sound(equivalent(table + "interpolation = \"smooth\"\n"));
  for (const auto* problem : {&straight, &smooth}) {
    const auto torque = [&](double w) { return problem->motor->torque.value(0, w, 0); };
    EXPECT_EQ(torque(-99), 8);
    EXPECT_EQ(torque(50), 20);
    EXPECT_EQ(torque(61), 0);
    EXPECT_TRUE(problem->motor->torque.of_speed);
  }
  EXPECT_NEAR(straight.motor->torque.value(0, 20, 0), 14, 1e-13);
  EXPECT_NEAR(straight.motor->torque.value(0, 57, 0), 6, 1e-13);
}

class MachineFault : public ::testing::TestWithParam<FaultCase> {};

TEST_P(MachineFault, IsFoundAtItsPlace) {
  expect_faults(GetParam());
}

const FaultCase kFaults[] = {
    {"nothing", "kind = \"machine\"\n", {{1, 1, "mechanism is missing; expected a [mechanism]"}}},
    {"no_type", "kind = \"machine\"\n[mechanism]\ncrank = 1\n", {{2, 1, "type is missing"}}},
    {"no_inertia",
     "kind = \"machine\"\n[mechanism]\ntype = \"scotch-yoke\"\npivot = [0, 0]\ncrank = 1\n",
     {{2, 1, "mechanism has no inertia"}}},
    {"load_without_mechanism",
     equivalent("inertia = 1\n[[load]]\non = \"B\"\nforce = [1, 0]\n"),
     {{4, 1, "load is given without [mechanism]"}}},
    {"sliding_drive",
     "kind = \"machine\"\n[mechanism]\ntype = \"chain\"\n[[mechanism.pivot]]\nname = \"A\"\nat = "
     "[0, 0]\n[mechanism.slider]\nslide = {through = [0, 1]}\npin = \"B\"\n[[mechanism.dyad]]\n"
     "type = \"RRR\"\njoins = [\"A\", \"B\"]\nlengths = [1, 1]\nnew = \"C\"\n[[link]]\nname = "
     "\"slider\"\nmass = 1\n",
     {{3, 8, "a slider or a cylinder drives"}}},
    {"unknown_keys",
     equivalent("inertia = 1\nintertia = 2\n[motor]\ntorque = 1\nslip = 2\n[run]\nturns = 3\n"),
     {{4, 1, "did you mean \"inertia\""}, {7, 1, "\"slip\""}, {9, 1, "\"turns_max\""}}},
    {"inertia_of_speed",
     equivalent("inertia = \"1 + w\"\n"),
     {{3, 16, "known are the variable phi, the constants"}}},
    {"torque_of_travel",
     equivalent("inertia = 1\ntorque = \"w*s\"\n"),
     {{4, 13, "known are the variables phi, w and t, the constants"}}},
    {"several_values",
     equivalent("inertia = 1\ntorque = \"1,5\"\n"),
     {{4, 12, "one expression in phi, w and t"}}},
    {"inertia_below_zero",
     equivalent("inertia = \"1 - 2*sin(phi)\"\n"),
     {{3, 11, "(30.05 degrees); expected an inertia from"}}},
    {"inertia_jumps", equivalent("inertia = \"phi < 2 ? 1 : 3\"\n"), {{3, 11, "jumps at phi = 0"}}},
    {"torque_not_finite",
     equivalent("inertia = 1\ntorque = \"1/(phi - pi)*0\"\n"),
     {{4, 10, "at phi = 3.14159 (180 degrees); expected a number"}}},
    {"rows_in_order",
     equivalent("inertia = [[0, 1], [90, 2], [80, 3]]\n"),
     {{3, 29, "row 3 of equivalent.inertia has the angle 80 after 90"}}},
    {"row_of_no_inertia",
     equivalent("inertia = [[0, 1], [90, 0]]\n"),
     {{3, 20, "row 2 of equivalent.inertia is 0; expected an inertia"}}},
    {"more_than_a_turn",
     equivalent("inertia = [[0, 1], [400, 2]]\n"),
     {{3, 20, "spans 400 degrees; expected a turn"}}},
    {"closing_row",
     equivalent("inertia = [[0, 1], [90, 2], [360, 3]]\n"),
     {{3, 29, "is 3 a turn after the first, 1; expected the same value"}}},
    {"one_row", equivalent("inertia = [[0, 1]]\n"), {{3, 11, "2"}}},
    {"interpolation_of_nothing",
     equivalent("inertia = 1\ninterpolation = \"smooth\"\n"),
     {{4, 17, "there is no table"}}},
    {"empty_equivalent",
     "kind = \"machine\"\n[equivalent]\n",
     {{2, 1, "equivalent.inertia is missing"}}},
    {"two_motors",
     equivalent("inertia = 1\n[motor]\ntorque = 3\ntable = [[0, 1], [1, 0]]\n"),
     {{6, 9, "motor.table is given beside motor.torque"}}},
    {"no_motor",
     equivalent("inertia = 1\n[motor]\nratio = 3\n"),
     {{4, 1, "motor.torque is missing"}}},
    {"motor_line",
     equivalent("inertia = 1\n[motor]\nline = {stall_torque = -3}\n"),
     {{5, 8, "motor.line.no_load_speed is missing"}, {5, 24, "motor.line.stall_torque is -3"}}},
    {"motor_table_over_angles",
     equivalent("inertia = 1\n[motor]\ntorque = [[0, 1], [90, 2]]\n"),
     {{5, 10, "under table = [[speed, torque], ...]"}}},
    {"speeds_in_order",
     equivalent("inertia = 1\n[motor]\ntable = [[0, 1], [0, 2]]\n"),
     {{5, 18, "row 2 of motor.table has the speed 0 after 0"}}},
    {"motor_numbers",
     equivalent("inertia = 1\n[motor]\ntorque = 1\nratio = 0\nefficiency = 1.1\ninertia = -1\n"),
     {{6, 9, "motor.ratio is 0"}, {7, 14, "motor.efficiency is 1.1"}, {8, 11, "inertia is -1"}}},
    {"train_beside_ratio",
     equivalent("inertia = 1\n[motor]\ntorque = 1\nratio = 2\nefficiency = 0.9\n"
                "train = {mesh = [{gears = [\"a\", \"b\"], teeth = [20, 40]}], "
                "input = [{member = \"a\"}], output = {member = \"b\"}}\n"),
     {{6, 9, "motor.ratio is given beside motor.train"},
      {7, 14, "motor.efficiency is given beside motor.train"}}},
    {"train_without_folder",
     equivalent("inertia = 1\n[motor]\ntorque = 1\ntrain = \"x.toml\"\n"),
     {{6, 9, "motor.train names a file beside the problem file, but there is none"}}},
    {"train_with_faults",
     equivalent("inertia = 1\n[motor]\ntorque = 1\n[[motor.train.mesh]]\n"
                "gears = [\"a\", \"b\"]\nteeth = [20, 2]\n"),
     {{8, 14, "motor.train.mesh[1].teeth"}}},
    {"train_output",
     equivalent("inertia = 1\n[motor]\ntorque = 1\noutput = \"c\"\n"
                "train = {mesh = [{gears = [\"a\", \"b\"], teeth = [20, 40]}], "
                "input = [{member = \"a\"}]}\n"),
     {{6, 10, "motor.output is \"c\", no shaft of the train"}}},
    {"part_of_no_train",
     equivalent("inertia = 1\n[motor]\ntorque = 1\nstate = \"1\"\n"),
     {{6, 9, "motor.state is given without motor.train"}}},
    {"two_flywheels",
     equivalent("inertia = 1\n[flywheel]\ninertia = 2\nfluctuation = 0.1\n"),
     {{6, 15, "flywheel.fluctuation is given beside flywheel.inertia"}}},
    {"no_flywheel",
     equivalent("inertia = 1\n[flywheel]\n"),
     {{4, 1, "flywheel.inertia is missing"}}},
    {"flywheel_of_a_start",
     equivalent("inertia = 1\n[flywheel]\nfluctuation = 0.1\n[run]\ntasks = [\"start\"]\n"),
     {{5, 15, "\"steady\" among the tasks"}}},
    {"brake_without_stop",
     equivalent("inertia = 1\n[brake]\ntorque = 3\n"),
     {{5, 10, "\"stop\" among the tasks"}}},
    {"tasks",
     equivalent("inertia = 1\n[run]\ntasks = [\"strat\", \"stop\", \"stop\"]\n"),
     {{5, 10, "perhaps for \"start\""}, {5, 27, "\"stop\" again"}}},
    {"run_numbers",
     equivalent("inertia = 1\n[run]\nstart_speed = -1\ntime_max = 0\nturns_max = 1e9\n"
                "speed_end = -2\nsteps = 3\ntolerance = 1\n"),
     {{5, 15, "start_speed is -1"},
      {6, 12, "time_max is 0"},
      {7, 13, "turns_max is"},
      {8, 13, "speed_end is -2"},
      {9, 9, "steps is 3"},
      {10, 13, "tolerance is 1"}}},
    {"load_of_the_frame",
     of_crank("[[load]]\non = \"frame\"\nforce = [1, 0]\nvalue = \"s\"\n"),
     {{11, 6, "is a point of the frame"}}},
    {"load_value",
     of_crank("[[load]]\non = \"slider\"\nforce = [1, 0]\nvalue = \"2*x\"\n"),
     {{13, 12, "known are the variables phi, w, t, s and v"}}}};

INSTANTIATE_TEST_SUITE_P(Machines, MachineFault, ::testing::ValuesIn(kFaults), name_of_case);

}  // namespace
}  // namespace cognate::problems::machine_problem_test
