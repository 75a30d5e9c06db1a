/// Machines with a gear train between motor and drive: against the same machine with the train's
/// figures by the textbooks' formulas, and against closed forms of its steady speed.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/machine_results.hpp"

namespace cognate::problems::machine_train_test {
namespace {

using test::column, test::quantity, test::result_of, test::says;

/// Sun of 24 teeth, planets of 30, ring of 84 held, modules of 2 mm; the first line is [motor]'s.
const std::string kPlanetary = R"(
[motor.train]
length_unit = "mm"
mechanism = {fixed = ["ring"]}
input = [{member = "sun"}]
output = {member = "carrier"}
[[motor.train.mesh]]
gears = ["sun", "planet"]
teeth = [24, 30]
module = 2
efficiency = 0.9
[[motor.train.mesh]]
gears = ["planet", "ring"]
teeth = [30, 84]
type = "internal"
module = 2
efficiency = 0.95
[[motor.train.planet]]
name = "planet"
carrier = "carrier"
count = 3
inertia = 0.0004
mass = 0.35
[[motor.train.shaft]]
name = "sun"
inertia = 0.002
[[motor.train.shaft]]
name = "carrier"
inertia = 0.03
)";

const double kMeshes = 0.9 * 0.95;
const double kRatio = 1 + 84.0 / 24;
/// Müller: of a planetary train with the ring held, i₀ = -z_ring/z_sun, power from sun to carrier
/// (1 - i₀ η₀)/(1 - i₀), from carrier to sun (1 - i₀)/(1 - i₀/η₀).
const double kForward = (1 + 3.5 * kMeshes) / 4.5;
const double kBackward = 4.5 / (1 + 3.5 / kMeshes);

/// At the carrier: the planet turns with ω_c (1 - z_ring/z_planet), its centre 54 mm from the axis.
double inertia_at_carrier() {
  const double planet = 1 - 84.0 / 30;
  return 0.03 + 0.002 * kRatio * kRatio + 3 * (0.0004 * planet * planet + 0.35 * 0.054 * 0.054);
}

/// A press with `motor`, its tables last.
std::string press(const std::string& motor) {
  return R"(
mechanism = {type = "slider-crank", pivot = [0, 0], crank = 0.1, coupler = 0.45}
[[link]]
name = "crank"
inertia = 0.3
[[link]]
name = "slider"
mass = 20
[[load]]
on = "slider"
force = [-4000, 0]
when = "advance"
stroke = [0.4, 1]
[run]
tasks = ["steady", "start"]
)" + motor;
}

TEST(MachineTrain, RunsAsWithTheFormulasOfTheTextbooks) {
  const std::string line = "line = {stall_torque = 595, no_load_speed = 157.08}\ninertia = 0.03\n";
  const auto train = result_of(press("[flywheel]\ninertia = 4\n[motor]\n" + line + kPlanetary));
  const auto plain = result_of(
      press(fmt::format("[flywheel]\ninertia = {:.17g}\n[motor]\n{}ratio = 4.5\nefficiency = "
                        "{:.17g}\n",
                        4 + inertia_at_carrier(), line, kForward)));
  ASSERT_EQ(train.status, Status::solved);
  ASSERT_EQ(plain.status, Status::solved);
  EXPECT_NEAR(quantity(train, "train_ratio"), kRatio, 1e-15);
  EXPECT_NEAR(quantity(train, "train_efficiency"), kForward, 1e-14);
  EXPECT_NEAR(quantity(train, "train_reverse_efficiency"), kBackward, 1e-14);
  EXPECT_NEAR(quantity(train, "train_inertia_kg_m2"), inertia_at_carrier(), 1e-14);
  for (const char* name : {"speed_mean_rad_s", "speed_max_rad_s", "fluctuation", "motor_work_J",
                           "motor_power_max_W", "start_time_s", "start_turns"}) {
    EXPECT_NEAR(quantity(train, name), quantity(plain, name), 1e-8 * quantity(plain, name)) << name;
  }
}

/// The motor of a machine whose equivalent torque is `load`.
std::string driven_by(const std::string& load, const std::string& motor,
                      const std::string& run = "") {
  return fmt::format("[equivalent]\ninertia = 5\ntorque = {}\n[run]\n{}\n[motor]\n{}", load, run,
                     motor);
}

const std::string kLine = "line = {stall_torque = 60, no_load_speed = 150}\n";

TEST(MachineTrain, PassesPowerBackWithTheEfficiencyOfThatSense) {
  // At the steady speed i T_m η = -load where the motor drives, i T_m/η_b = -load where it brakes.
  const auto speed = [](double load, double share) {
    const double torque = -load * share / kRatio;
    return 150 * (1 - torque / 60) / kRatio;
  };
  const auto pulled = result_of(driven_by("-90", kLine + kPlanetary));
  EXPECT_NEAR(quantity(pulled, "speed_mean_rad_s"), speed(-90, 1 / kForward), 1e-9);
  const auto pushed = result_of(driven_by("90", kLine + kPlanetary));
  EXPECT_NEAR(quantity(pushed, "speed_mean_rad_s"), speed(90, kBackward), 1e-9);
  EXPECT_GT(quantity(pushed, "speed_mean_rad_s"), 150 / kRatio);
}

/// A pair of external gears: the drive turns against the motor.
const std::string kPair = R"(
[motor.train]
input = [{member = "a"}]
output = {member = "b"}
mesh = [{gears = ["a", "b"], teeth = [20, 60], efficiency = 0.96}]
)";

TEST(MachineTrain, TurnsAsTheSignOfItsRatioSays) {
  const auto backwards = result_of(driven_by("\"-w\"", kLine + kPair));
  EXPECT_EQ(backwards.status, Status::no_solution);
  EXPECT_EQ(quantity(backwards, "train_ratio"), -3);
  EXPECT_TRUE(says(backwards, "motor.reversed = true"));
  const auto forwards = result_of(driven_by("\"-w\"", kLine + "reversed = true\n" + kPair));
  ASSERT_EQ(forwards.status, Status::solved);
  // 3*0.96*60*(1 - 3 w/150) = w
  const double slope = 3 * 0.96 * 60;
  EXPECT_NEAR(quantity(forwards, "speed_mean_rad_s"), slope / (1 + slope * 3 / 150), 1e-9);
}

/// 100·101/(99·100) by nearly equal gears: self-locking when driven back.
const std::string kLocking = R"(
[motor.train]
mechanism = {fixed = ["held"]}
input = [{member = "arm"}]
output = {member = "out"}
planet = [{name = "planets", carrier = "arm"}]
mesh = [{gears = ["out", "planets"], teeth = [20, 21], efficiency = 0.95},
        {gears = ["planets", "held"], teeth = [20, 19], efficiency = 0.95}]
)";

TEST(MachineTrain, HoldsALoadThatPushesASelfLockingTrain) {
  const std::string start = "tasks = [\"start\"]\nturns_max = 5\n";
  const auto off = result_of(driven_by("40", "torque = 0\n" + kLocking, start));
  EXPECT_TRUE(says(off, "self-locking"));
  EXPECT_TRUE(says(off, "stands still"));
  EXPECT_EQ(column(off.motions.front(), "speed_rad_s").back(), 0);
  // Pushed on, it keeps to the speed at which the motor gives no torque.
  const auto pushed = result_of(driven_by("40", kLine + kLocking));
  ASSERT_EQ(pushed.status, Status::solved);
  const double no_load = 150 / quantity(pushed, "train_ratio");
  EXPECT_NEAR(quantity(pushed, "speed_mean_rad_s"), no_load, 1e-4 * no_load);
  // Pushed back, it is held by a motor too weak to turn it on.
  const auto weak = result_of(driven_by("-1e4", kLine + kLocking, start));
  EXPECT_TRUE(says(weak, "stands still"));
}

}  // namespace
}  // namespace cognate::problems::machine_train_test
