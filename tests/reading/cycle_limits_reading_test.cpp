// Limits over the full turn in files: what is read, and what is wrong with others.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::cycle_limits_reading_test {
namespace {

const std::string kPath =
    "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1, 0], [1, 1]]\n";

// A crank-rocker with `lines` after its class: the first of them is line 6.
std::string path(const std::string& lines) {
  return kPath + "[constraints]\nclass = \"crank-rocker\"\n" + lines;
}

std::string function(const std::string& target, const std::string& lines) {
  return "kind = \"function-generation\"\n[target]\npairs_deg = [[0, 0], [20, 10], [40, 30]]\n" +
         target + "[constraints]\nclass = \"crank-rocker\"\n" + lines;
}

std::string motion(const std::string& method, const std::string& lines) {
  return "kind = \"motion-generation\"\n[target]\nmethod = \"" + method +
         "\"\nposes = [[0, 0, 0], [1, 0, 10], [2, 1, 30], [3, 1, 50]]\n[constraints]\nclass = "
         "\"crank-rocker\"\n" +
         lines;
}

const std::string kMachine =
    "[drive]\nspeed = 2\n[[link]]\nname = \"crank\"\nmass_per_length = 1\n";

const PathProblem& as_path(const Task& task) {
  return std::get<PathProblem>(task);
}

TEST(CycleLimitsReading, TakesWhatIsGiven) {
  const auto task = parse_task(path(R"(peak_speed_max = 5
peak_acceleration_max = 40
torque_ripple_max = 3
clearance = [{ point = "coupler-point", inside = [[-1, -2], [3, 4]] },
             { point = "C", outside = [[5, 6], [7, 8]] }]
[drive]
speed = 12
[[link]]
name = "crank"
mass_per_length = 0.5
[[link]]
between = ["C", "B"]
mass = 2
centre = [0.25, 0.5]
inertia = 0.125
[[load]]
on = "coupler-point"
force = [1, -2]
[[load]]
on = ["D", "C"]
at = [0.5, 0]
torque = 4
)"));
  ASSERT_TRUE(task) << task.error().front().message;
  const Constraints& read = as_path(*task).constraints;
  EXPECT_EQ(read.cycle_max[CycleQuantity::peak_speed], 5);
  EXPECT_EQ(read.cycle_max[CycleQuantity::peak_acceleration], 40);
  EXPECT_EQ(read.cycle_max[CycleQuantity::torque_ripple], 3);
  ASSERT_EQ(read.clearances.size(), 2);
  EXPECT_TRUE(read.clearances[0].inside);
  EXPECT_EQ(read.clearances[0].box.max, (Vec2d{3, 4}));
  EXPECT_EQ(read.clearances[1].point, MovingPoint::c);
  EXPECT_FALSE(read.clearances[1].inside);
  const Operation& operation = read.operation;
  EXPECT_EQ(operation.speed, 12);
  EXPECT_EQ(operation.links[0].mass_per_length, 0.5);
  EXPECT_EQ(operation.links[0].centre.share, 0.5);
  // Counted from C towards B, the centre lies a quarter before C and half a unit to the other side.
  EXPECT_EQ(operation.links[1].centre.share, 1);
  EXPECT_EQ(operation.links[1].centre.offset, (Vec2d{-0.25, -0.5}));
  EXPECT_EQ(operation.links[1].moment, 0.125);
  ASSERT_EQ(operation.loads.size(), 2);
  EXPECT_TRUE(operation.loads[0].at.at_coupler_point);
  EXPECT_EQ(operation.loads[1].at.link, MovingLink::rocker);
  EXPECT_EQ(operation.loads[1].at.offset, (Vec2d{0.5, 0}));
}

TEST(CycleLimitsReading, TakesTheRunningMachine) {
  const auto task = parse_task(path(R"(speed_fluctuation_max = 0.1
flywheel_inertia_max = 7
motor_power_max = 300
[drive]
speed = -12
[flywheel]
inertia = 5
fluctuation = 0.05
[[link]]
name = "crank"
mass_per_length = 0.5
[[load]]
on = "C"
force = [1, -2]
when = "return"
)"));
  ASSERT_TRUE(task) << task.error().front().message;
  const Constraints& read = as_path(*task).constraints;
  EXPECT_EQ(read.cycle_max[CycleQuantity::speed_fluctuation], 0.1);
  EXPECT_EQ(read.cycle_max[CycleQuantity::flywheel_inertia], 7);
  EXPECT_EQ(read.cycle_max[CycleQuantity::motor_power], 300);
  EXPECT_FALSE(read.cycle_max[CycleQuantity::torque_ripple]);
  EXPECT_EQ(read.operation.speed, -12);
  EXPECT_EQ(read.operation.flywheel, 5);
  EXPECT_EQ(read.operation.fluctuation, 0.05);
  EXPECT_EQ(read.operation.loads.at(0).sense, LoadSense::retreat);
}

TEST(CycleLimitsReading, TakesWhatIsAnObjectiveAlone) {
  const auto task = parse_task(path(kMachine + R"([flywheel]
fluctuation = 0.05
[solve]
objectives = ["error", "flywheel_inertia"]
)"));
  ASSERT_TRUE(task) << task.error().front().message;
  EXPECT_EQ(as_path(*task).constraints.cycle_max[CycleQuantity::flywheel_inertia], INFINITY);
  EXPECT_EQ(as_path(*task).constraints.operation.fluctuation, 0.05);
}

class CycleLimitsFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(CycleLimitsFaults, AreAllReported) {
  expect_faults(GetParam());
}

const std::string kRods = "[[link]]\nname = \"crank\"\nmass_per_length = 1\n";

INSTANTIATE_TEST_SUITE_P(
    CycleLimits, CycleLimitsFaults,
    ::testing::ValuesIn(std::vector<FaultCase>{
        {"NoClass",
         kPath + "[constraints]\npeak_acceleration_max = 1\n",
         {{5, 25, "class = \"crank-rocker\" or \"double-crank\" as well"}}},
        {"NotPositive",
         path("peak_acceleration_max = 0\n"),
         {{6, 25, "is 0; expected a number from 1e-30 to 1e30"}}},
        {"TheWholePlane",
         path("[[constraints.clearance]]\npoint = \"B\"\ninside = [[-inf, -inf], [inf, inf]]\n"),
         {{8, 10, "is the whole plane; expected at least one finite side"}}},
        {"BeyondThePlane",
         path("[[constraints.clearance]]\npoint = \"B\"\ninside = [[inf, 0], [inf, 5]]\n"),
         {{8, 10, "is an empty region"}}},
        {"NoPoint",
         path("[[constraints.clearance]]\ninside = [[0, 0], [1, 1]]\n"),
         {{6, 1, "point is missing; expected \"coupler-point\", \"B\" or \"C\""}}},
        {"WrongPoint",
         path("[[constraints.clearance]]\npoint = \"D\"\ninside = [[0, 0], [1, 1]]\n"),
         {{7, 9, "allowed are \"coupler-point\", \"B\", \"C\""}}},
        {"NoBox",
         path("[[constraints.clearance]]\npoint = \"B\"\n"),
         {{6, 1, "inside is missing; expected inside or outside = [[xmin, ymin], [xmax, ymax]]"}}},
        {"TwoBoxes",
         path("[[constraints.clearance]]\npoint = \"B\"\ninside = [[0, 0], [1, 1]]\noutside = [[0, "
              "0], [1, 1]]\n"),
         {{9, 11, "is given beside inside; give one of them"}}},
        {"FlatObstacle",
         path("[[constraints.clearance]]\npoint = \"B\"\noutside = [[0, 0], [1, 0]]\n"),
         {{8, 11, "has no area"}}},
        {"NothingWeighs",
         path("torque_ripple_max = 1\n"),
         {{1, 1, "expected [[link]] with masses or [[load]]"}}},
        {"LinkForNothing",
         path("peak_acceleration_max = 1\n" + kRods),
         {{7, 1, "no limit depends on it; add constraints.torque_ripple_max"}}},
        {"DriveForNothing", path("[drive]\nspeed = 2\n"), {{6, 1, "no limit depends on it"}}},
        {"SpeedZero",
         path("peak_acceleration_max = 1\n[drive]\nspeed = 0\n"),
         {{8, 9, "expected a speed in rad/s, not 0,"}}},
        {"RodAndMass",
         path("torque_ripple_max = 1\n" + kRods + "mass = 1\n"),
         {{10, 8, "is given beside mass_per_length"}}},
        {"LinkTwice",
         path("torque_ripple_max = 1\n" + kRods + kRods),
         {{10, 1, "gives \"crank\" a second time"}}},
        {"NoLink",
         path("torque_ripple_max = 1\n[[link]]\nbetween = [\"A\", \"C\"]\nmass_per_length = 1\n"),
         {{8, 11, "which are not the joints of one moving link"}}},
        {"LoadOfAStrokeOnTheCoupler",
         path("torque_ripple_max = 1\n[[load]]\non = \"coupler-point\"\nforce = [1, 0]\nwhen = "
              "\"advance\"\n"),
         {{10, 8, "names a stroke of the rocker, on which the load is not; expected \"always\""}}},
        {"LoadOfAStrokeThatIsNone",
         kPath + "[constraints]\nclass = \"double-crank\"\ntorque_ripple_max = 1\n[[load]]\non = "
                 "\"C\"\nforce = [1, 0]\nwhen = \"return\"\n",
         {{10, 8, "which needs constraints.class = \"crank-rocker\""}}},
        {"LoadInAnInterval",
         path("torque_ripple_max = 1\n[[load]]\non = \"C\"\nforce = [1, 0]\nwhen = [0, 90]\n"),
         {{10, 8, "expected \"always\", \"advance\" or \"return\""}}},
        {"NoSpeed",
         path("speed_fluctuation_max = 0.1\n" + kRods),
         {{1, 1, "speed is missing; expected the crank's mean speed in rad/s"}}},
        {"NoSpeedForPower",
         path("motor_power_max = 10\n[drive]\n" + kRods),
         {{7, 1, "speed is missing; expected the crank's mean speed in rad/s"}}},
        {"FluctuationOfTwo",
         path("speed_fluctuation_max = 2\n" + kMachine),
         {{6, 25, "is 2; expected a number below 2, at least 1e-12"}}},
        {"NoFluctuationForAFlywheel",
         path("flywheel_inertia_max = 4\n" + kMachine + "[flywheel]\ninertia = 3\n"),
         {{12, 1, "fluctuation is missing; expected the fluctuation that the flywheel is to leave"},
          {13, 11, "no limit depends on it; add constraints.speed_fluctuation_max"}}},
        {"FluctuationForNothing",
         path("speed_fluctuation_max = 0.1\n" + kMachine + "[flywheel]\nfluctuation = 0.1\n"),
         {{13, 15, "no limit depends on it; add constraints.flywheel_inertia_max"}}},
        {"NothingKeepsUpTheSpeed",
         path("speed_fluctuation_max = 0.1\n[drive]\nspeed = 2\n[[load]]\non = \"C\"\nforce = [1, "
              "0]\n"),
         {{1, 1, "expected [[link]] with masses or a flywheel"}}},
        {"FluctuationWithoutClass",
         kPath + "[constraints]\nspeed_fluctuation_max = 0.1\n" + kMachine,
         {{5, 25, "class = \"crank-rocker\" or \"double-crank\" as well"}}},
        {"LoadOnNothing",
         path("torque_ripple_max = 1\n[[load]]\non = \"P\"\nforce = [1, 0]\n"),
         {{8, 6, "allowed are \"coupler-point\", \"B\", \"C\", \"crank\", \"coupler\", "}}},
        {"Certified",
         path("peak_acceleration_max = 1\n[solve]\ncertify = true\n"),
         {{8, 11, "of which a certificate knows nothing"}}},
        {"Ceres",
         kPath + "[constraints]\nclass = \"crank-rocker\"\npeak_acceleration_max = "
                 "1\n[solve]\nsolver = \"ceres\"\n",
         {{8, 10, "is \"ceres\", which honours bounds but not constraints.class"}}},
        {"PlaceOfAFunction",
         function("", "[[constraints.clearance]]\npoint = \"B\"\ninside = [[0, 0], [1, 1]]\n"),
         {{6, 1, "a function generator has none"}}},
        {"ExactFunction",
         function("objective = \"exact\"\n", "peak_acceleration_max = 1\n"),
         {{7, 25, "is given with exact synthesis"}}},
        {"ExactMotion",
         motion("exact", "peak_acceleration_max = 1\n"),
         {{7, 25, "expected method = \"least-squares\""}}},
        {"MotionWithSlider",
         motion("least-squares",
                "peak_acceleration_max = 1\n[mechanism]\ndyads = [\"RR\", \"PR\"]\n"),
         {{9, 9, "expected dyads = [\"RR\"]"}}},
    }),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace cognate::problems::cycle_limits_reading_test
