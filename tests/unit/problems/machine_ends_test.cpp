/// Where starts and stops of machines end, and what is said of that.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/machine_results.hpp"

namespace cognate::problems::machine_ends_test {
namespace {

using test::column, test::quantity, test::result_of, test::says;

TEST(MachineEnds, OfAKiteIsNotHeldWhereItsJointsMeet) {
  const MachineResult result = result_of(R"(
mechanism = {type = "four-bar", fixed_pivots = [[0, 0], [1, 0]], crank = 1, coupler = 2, rocker = 2}
link = [{name = "crank", inertia = 2}]
motor = {line = {stall_torque = 20, no_load_speed = 10}}
run = {start_deg = 90, tasks = ["steady", "start"]}
)");
  EXPECT_FALSE(says(result, "vanishes"));
  EXPECT_TRUE(says(result, "the drive does not hold the mechanism at 0°"));
  EXPECT_TRUE(says(result, "further on than 0°"));
  EXPECT_NEAR(quantity(result, "start_turns"), 0.75, 1e-6);
}

TEST(MachineEnds, OfATangentGeneratorEndsWhereThatIsAtInfinity) {
  const MachineResult result = result_of(R"(
mechanism = {type = "tangent-generator", offset = 0.2}
link = [{name = "lever", mass = 5, centre = [0, 0], inertia = 1}]
motor = {line = {stall_torque = 20, no_load_speed = 10}}
run = {tasks = ["steady", "start"], start_deg = 30}
)");
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_NEAR(quantity(result, "start_turns"), 150.0 / 360, 1e-6);
  EXPECT_TRUE(says(result, "can be assembled from 0° to 180° and from 180° to 360°"));
  EXPECT_TRUE(says(result, "cannot be assembled further on than 180°"));
  EXPECT_EQ(result.notes.size(), 3u);
  // ω after φ of a motor 20 − 2 ω: the speed at the end is that of the free machine.
  const auto& speeds = column(result.motions.at(0), "speed_rad_s");
  EXPECT_TRUE(std::ranges::all_of(speeds, [](double speed) { return std::isfinite(speed); }));
}

TEST(MachineEnds, ThatCannotBeAssembledAtItsStartSaysSo) {
  const MachineResult result = result_of(R"(
mechanism = {type = "four-bar", fixed_pivots = [[0, 0], [2, 0]], crank = 2, coupler = 1.5, rocker = 2}
link = [{name = "rocker", inertia = 2}]
motor = {line = {stall_torque = 20, no_load_speed = 10}}
run = {tasks = ["start"], start_deg = 5}
)");
  EXPECT_TRUE(says(result, "cannot be assembled where it begins, at 5°"));
  EXPECT_TRUE(says(result, "can be assembled from 14.3615° to 122.09°"));
  EXPECT_FALSE(says(result, "further on"));
}

TEST(MachineEnds, EndsAtTheTimeOrTurnsOfItsFile) {
  const std::string coasting =
      "equivalent = {inertia = 1, torque = -1}\nmotor = {torque = 0}\n"
      "[run]\nstart_speed = 4\n";
  for (const char* task : {"start", "stop"}) {
    for (const char* limit : {"time_max = 1", "turns_max = 0.25"}) {
      const MachineResult result =
          result_of(coasting + "tasks = [\"" + task + "\"]\n" + limit + "\n");
      EXPECT_EQ(result.status, Status::solved) << task << " " << limit;
      EXPECT_TRUE(says(result, "ended at its limit")) << task << " " << limit;
    }
  }
}

TEST(MachineEnds, AtRestAsksForTheTimeThatItMayWait) {
  // Static friction of 10 N m yields to a torque of t after 10 s: ω = (t − 10)²/2.
  const std::string late = R"(
equivalent = {inertia = 1, torque = "w > 0 ? -10 : w < 0 ? 10 : 0"}
motor = {torque = "t"}
[run]
tasks = ["start"]
)";
  EXPECT_TRUE(says(result_of(late), "run.time_max says how long to wait"));
  EXPECT_TRUE(says(result_of(late + "turns_max = 2\n"), "run.time_max says how long to wait"));
  EXPECT_NEAR(quantity(result_of(late + "time_max = 14\n"), "start_end_speed_rad_s"), 8, 0.02);
}

TEST(MachineEnds, SaysThatATableIsTooCoarseForItsTurns) {
  const auto start = [](const std::string& inertia, int steps) {
    return result_of(fmt::format(R"(
equivalent = {{inertia = {}}}
motor = {{torque = 50}}
run = {{tasks = ["start"], turns_max = 40, steps = {}}}
)",
                                 inertia, steps));
  };
  EXPECT_TRUE(says(start("'2 + cos(phi)'", 360), "has 361 rows for 40 turns"));
  EXPECT_FALSE(says(start("'2 + cos(phi)'", 720), "rows for"));
  EXPECT_FALSE(says(start("2", 360), "rows for")) << "nothing changes within a turn";
}

TEST(MachineEnds, SaysWhereASpeedOutOfReachLeavesIt) {
  const auto start = [](const std::string& run) {
    return result_of(
        "equivalent = {inertia = 1}\nmotor = {torque = \"50 - w\"}\n"
        "[run]\ntasks = [\"start\"]\n" +
        run);
  };
  const MachineResult below = start("start_speed = 80\nspeed_end = 30\n");
  EXPECT_EQ(below.status, Status::infeasible);
  EXPECT_TRUE(says(below, "the speed does not reach 30 rad/s: it settles at 50 rad/s"));
  EXPECT_TRUE(says(start("start_speed = 80\nspeed_end = 90\n"), "it settles at 50 rad/s"));
  EXPECT_TRUE(says(start("speed_end = 51\n"), "it settles at 50 rad/s"));
  EXPECT_EQ(start("start_speed = 80\nspeed_end = 60\n").status, Status::solved);
  EXPECT_EQ(start("start_speed = 20\nspeed_end = 40\n").status, Status::solved);
}

TEST(MachineEnds, SaysOnceWhyThereIsNoFlywheel) {
  const std::string balanced = R"toml(
equivalent = {inertia = 1, torque = "-100*(1 + cos(phi))"}
motor = {torque = 100}
flywheel = {fluctuation = 0.1}
)toml";
  const MachineResult unknown = result_of(balanced);
  ASSERT_EQ(unknown.notes.size(), 1u);
  EXPECT_TRUE(says(unknown, "give run.start_speed"));
  const MachineResult known = result_of(balanced + "run = {start_speed = 30}\n");
  EXPECT_EQ(known.status, Status::solved);
  ASSERT_EQ(known.notes.size(), 1u);
  EXPECT_TRUE(says(known, "that of the start is taken"));
  problems::Run run;
  run.time_limit = 0;
  const MachineResult stopped = run_machine(test::parse(balanced), run);
  ASSERT_EQ(stopped.notes.size(), 1u);
  EXPECT_TRUE(says(stopped, "out of time"));
}

TEST(MachineEnds, AnEvenSpeedIsNowhereGreatest) {
  // A parallelogram, whose coupler does not turn.
  const MachineResult even = result_of(R"toml(
mechanism = {type = "four-bar", fixed_pivots = [[0, 0], [3, 0]], crank = 1, coupler = 3, rocker = 1}
link = [{name = "coupler", mass = 2, centre = [1, 0.5]}, {name = "rocker", inertia = 3}]
motor = {torque = "50 - w"}
run = {start_deg = 30}
)toml");
  EXPECT_NEAR(quantity(even, "speed_max_rad_s"), 50, 1e-7);
  EXPECT_GT(quantity(even, "fluctuation"), 0) << "by rounding";
  const auto is_place = [](const Quantity& each) { return each.name.ends_with("_at_deg"); };
  EXPECT_TRUE(std::ranges::none_of(even.quantities, is_place));
  const MachineResult uneven =
      result_of("equivalent = {inertia = 1, torque = 'cos(phi)'}\nmotor = {torque = '50 - w'}\n");
  EXPECT_EQ(std::ranges::count_if(uneven.quantities, is_place), 2);
}

TEST(MachineEnds, SaysThatItGoesBackwards) {
  const MachineResult result = result_of(R"(
equivalent = {inertia = 1}
motor = {torque = "-10 - w"}
run = {tasks = ["steady", "start"], turns_max = 5}
)");
  EXPECT_LT(quantity(result, "start_turns"), 0);
  EXPECT_EQ(std::ranges::count_if(result.notes,
                                  [](const std::string& note) {
                                    return note.starts_with("the machine goes backwards");
                                  }),
            1);
  EXPECT_FALSE(says(result_of("equivalent = {inertia = 1, torque = -5}\nmotor = {torque = 5}\n"),
                    "backwards"));
}

}  // namespace
}  // namespace cognate::problems::machine_ends_test
