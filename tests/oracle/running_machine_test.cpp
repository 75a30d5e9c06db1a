/// The running machine against the worked examples of machines.toml.
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "analysis/machine/flywheel.hpp"
#include "analysis/machine/reduction.hpp"
#include "analysis/machine/run.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/machines.hpp"

namespace cognate::machine::running_machine_test {
namespace {

using test::PeriodicTable;

const toml::table& data() {
  static const toml::table table = toml::parse_file(std::string(kOracleFolder) + "/machines.toml");
  return table;
}

double number(toml::node_view<const toml::node> node) {
  return *node.value<double>();
}

std::vector<double> column(toml::node_view<const toml::node> node) {
  std::vector<double> values;
  for (const auto& value : *node.as_array()) values.push_back(*value.value<double>());
  return values;
}

void expect_close(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

/// Example 6-1, the coupler's centre of mass at `centre` from the crank's pin.
class SliderCrankInertia {
 public:
  explicit SliderCrankInertia(double centre) : motion_(mechanism()) {
    const auto given = data()["equivalent_inertia"];
    inertias_ = {{},
                 {0, {}, number(given["crank_moment"])},
                 {number(given["coupler_mass"]), {centre, 0}, number(given["coupler_moment"])},
                 {number(given["slider_mass"])}};
  }

  EquivalentInertia at(double phi) {
    motion_.move_to(phi);
    return equivalent_inertia(motion_.bodies(), inertias_);
  }

 private:
  static Mechanism<double> mechanism() {
    const auto given = data()["equivalent_inertia"];
    const double crank = number(given["crank"]);
    return {
        Crank<double>{{}, crank},
        {Rrp<double>{
            {1, {crank, 0}}, number(given["coupler"]), {0, {}, {1, 0}, number(given["offset"])}}}};
  }

  MechanismMotion<2> motion_;
  std::vector<Inertia> inertias_;
};

struct Centre {
  const char* name;
  double at;
};

class CoupledMass : public ::testing::TestWithParam<Centre> {};
INSTANTIATE_TEST_SUITE_P(Example, CoupledMass,
                         ::testing::Values(Centre{"centre_0_2", 0.2}, Centre{"centre_0_25", 0.25}));

TEST_P(CoupledMass, HasTheInertiaOfExample61) {
  const auto given = data()["equivalent_inertia"];
  const auto angles = column(given["crank_deg"]);
  const auto values = column(given[GetParam().name]["J"]);
  const auto slopes = column(given[GetParam().name]["slope"]);
  SliderCrankInertia inertia(GetParam().at);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto [value, slope] = inertia.at(angles[i] * kDegree);
    expect_close(value, values[i], 1e-12);
    expect_close(slope, slopes[i], 1e-11);
  }
}

TEST_P(CoupledMass, RunsAtTheSpeedsOfExample62) {
  // Torque of the angle alone, which does no work in a turn: every speed repeats itself.
  const auto given = data()["torque_of_angle"];
  const PeriodicTable torque{column(given["torque"])};
  const auto speeds = column(given[std::string("speeds_") + GetParam().name]);
  SliderCrankInertia inertia(GetParam().at);
  const Machine machine = test::machine_of([&](double phi) { return inertia.at(phi); },
                                           [&](double phi, double, double) {
                                             return Torques{0, torque.at(phi)};
                                           },
                                           torque.breaks());
  const SteadyState steady =
      steady_state(machine, {.speed = number(given["speed"])}, {.relative = 1e-12}, 36);
  EXPECT_EQ(steady.missing, NoSteadyState::any_speed);
  ASSERT_EQ(steady.states.size(), 37U);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    expect_close(steady.states[i].omega, speeds[i], 1e-10);
  }
  expect_close(steady.states[36].omega, speeds[0], 1e-10);
  // 109.9557… J up to the second row: the trapezoid of 720 and 540 N m.
  expect_close(steady.states[1].load_work, (720 + 540) / 2.0 * 10 * kDegree, 1e-12);
  EXPECT_GE(steady.greatest.omega, *std::ranges::max_element(speeds));
  EXPECT_LE(steady.least.omega, *std::ranges::min_element(speeds));
}

class MotorLine : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Example, MotorLine, ::testing::Values(26500, 25400));

TEST_P(MotorLine, StartsAsInExample63) {
  const auto given = data()["motor_line"];
  const auto expected = given["a" + std::to_string(static_cast<int>(GetParam()))];
  const double slope = number(given["slope"]);
  const Machine machine = test::machine_of(test::constant_inertia(number(given["inertia"])),
                                           [&](double, double omega, double) {
                                             return Torques{GetParam() - slope * omega, 0};
                                           });
  const auto speeds = column(expected["speeds"]), times = column(expected["times"]);
  const auto angles = column(expected["angles"]);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const MachineRun start = run(machine, {}, {.speed = speeds[i]}, {.relative = 1e-13}, 0);
    ASSERT_EQ(start.stop, RunStop::speed);
    EXPECT_EQ(start.states.back().omega, speeds[i]);
    expect_close(start.states.back().time, times[i], 1e-10);
    expect_close(start.states.back().phi, angles[i], 1e-10);
  }
  const SteadyState steady = steady_state(machine, {}, {}, 4);
  ASSERT_EQ(steady.missing, NoSteadyState::none);
  expect_close(steady.greatest.omega, number(expected["steady"]), 1e-10);
  EXPECT_NEAR(fluctuation(steady), 0, 1e-10);
}

TEST(MotorLine, NeverReachesASpeedBeyondItsSteadyOne) {
  // With the load that the book's program leaves out, 96.21 rad/s are all; it integrates to 100.
  const Machine machine =
      test::machine_of(test::constant_inertia(10), [](double, double omega, double) {
        return Torques{26500 - 264 * omega, -1100};
      });
  const MachineRun start = run(machine, {}, {.time = 10, .speed = 100}, {}, 0);
  EXPECT_EQ(start.stop, RunStop::time);
  expect_close(start.states.back().omega, 25400.0 / 264, 1e-9);
}

/// Examples 6-4 and 6-5.
struct Shaper {
  PeriodicTable inertia{column(data()["shaper"]["inertia"])};
  PeriodicTable load{column(data()["shaper"]["load"])};

  Machine with(double flywheel) const {
    return test::machine_of(
        [*this, flywheel](double phi) {
          return EquivalentInertia{inertia.at(phi) + flywheel, inertia.slope(phi)};
        },
        [*this](double phi, double omega, double) {
          return Torques{5500 - 1000 * omega, -load.at(phi)};
        },
        inertia.breaks());
  }
};

class ShaperExample : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Example, ShaperExample, ::testing::Values("bare", "flywheel"));

TEST_P(ShaperExample, HasTheSteadySpeeds) {
  const auto given = data()["shaper"][GetParam()];
  const Machine machine = Shaper().with(number(given["flywheel"]));
  const SteadyState steady = steady_state(machine, {}, {.relative = 1e-13}, 720);
  ASSERT_EQ(steady.missing, NoSteadyState::none);
  const auto speeds = column(given["speeds"]);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    expect_close(steady.states[30 * i].omega, speeds[i], 1e-9);
  }
  const auto [least, greatest] =
      std::ranges::minmax_element(steady.states, {}, &MachineState::omega);
  expect_close(greatest->omega, number(given["greatest"]), 1e-8);
  expect_close(least->omega, number(given["least"]), 1e-8);
  // Refined extremes lie beyond those of every 0.5°, and make what is reported of the speeds so.
  EXPECT_GE(steady.greatest.omega, greatest->omega);
  EXPECT_LE(steady.least.omega, least->omega);
  EXPECT_NEAR(fluctuation(steady), number(given["fluctuation"]), 1e-7);
  EXPECT_LT(steady.energy_residual, 1e-11);
}

/// The book's method: J ω Δω/Δφ + ½ ω² ΔJ/Δφ = M at the beginning of every step of 15°, from turn
/// to turn until nothing changes.
std::vector<double> euler(const Shaper& shaper, double flywheel) {
  const auto& inertia = shaper.inertia.values;
  const double step = shaper.inertia.step();
  std::vector<double> speeds(24, 5);
  for (int turn = 0; turn < 400; ++turn) {
    for (std::size_t i = 0; i < 24; ++i) {
      const double w = speeds[i];
      const double torque = 5500 - 1000 * w - shaper.load.values[i];
      const double bend = 0.5 * w * w * (inertia[(i + 1) % 24] - inertia[i]) / step;
      speeds[(i + 1) % 24] = w + step * (torque - bend) / ((inertia[i] + flywheel) * w);
    }
  }
  return speeds;
}

TEST_P(ShaperExample, IsMissedByTheBooksMethod) {
  const auto given = data()["shaper"][GetParam()];
  const auto speeds = euler(Shaper(), number(given["flywheel"]));
  const auto printed = column(given["euler_speeds"]);
  for (std::size_t i = 0; i < speeds.size(); ++i) expect_close(speeds[i], printed[i], 1e-9);
  const auto [least, greatest] = std::ranges::minmax(speeds);
  expect_close(2 * (greatest - least) / (greatest + least), number(given["euler_fluctuation"]),
               1e-9);
}

TEST(ShaperExample, NeedsTheFlywheelThatGivesItsFluctuation) {
  const auto given = data()["shaper"]["flywheel"];
  const Shaper shaper;
  const auto machine_with = [&](double inertia) { return shaper.with(inertia); };
  const Flywheel found = flywheel_for(machine_with, number(given["fluctuation"]), {}, {}, 24);
  ASSERT_TRUE(found.found);
  expect_close(found.inertia, number(given["flywheel"]), 2e-6);  // its extremes are every 0.5°
  EXPECT_NEAR(fluctuation(found.steady), number(given["fluctuation"]), 1e-10);
  EXPECT_GT(found.approximate, found.inertia);
}

}  // namespace
}  // namespace cognate::machine::running_machine_test
