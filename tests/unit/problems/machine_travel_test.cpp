/// How far loaded bodies have travelled, and where all that has mass stands still.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/machine/vanishing_inertia.hpp"
#include "tests/support/machine_results.hpp"

namespace cognate::problems::machine_travel_test {
namespace {

using test::column, test::quantity, test::result_of, test::says;

/// A crank-rocker 0.5, 1, 1.2, 1.6, turned in the plane by `turned`, whose rocker carries a spring.
std::string sprung_rocker(double turned) {
  return fmt::format(R"toml(
mechanism = {{type = "four-bar", fixed_pivots = [[0, 0], [{}, {}]], crank = 0.5, coupler = 1, rocker = 1.2}}
link = [{{name = "crank", inertia = 2}}]
load = [{{on = "rocker", torque = -1, value = "10*(s - 0.4)"}}]
motor = {{line = {{stall_torque = 20, no_load_speed = 10}}}}
run = {{start_deg = {}}}
)toml",
                     1.6 * std::cos(turned), 1.6 * std::sin(turned), turned * 180 / kPi);
}

TEST(MachineTravel, OfASwingingBodyIsCountedFromTheEndOfItsSwing) {
  const double a = 0.5, b = 1, c = 1.2, d = 1.6;
  // The angle of the rocker, its pivot at (d, 0), with the coupler's far end at `from_pivot`.
  const auto inner = [&](double distance, double opposite) {
    return std::acos((distance * distance + c * c - opposite * opposite) / (2 * distance * c));
  };
  const double least = kPi - inner(d, a + b);
  const auto travel = [&](double phi) {
    const double x = a * std::cos(phi) - d, y = a * std::sin(phi);
    return std::remainder(std::atan2(y, x) - inner(std::hypot(x, y), b) - least, kTurn);
  };
  const auto energy = [&](double phi) { return 5 * std::pow(travel(phi) - 0.4, 2); };
  for (const double turned : {0.0, 0.7, 2.0, 3.1, -1.3}) {
    const MachineResult result = result_of(sprung_rocker(turned));
    ASSERT_EQ(result.status, Status::solved) << turned;
    const auto& angles = column(result.motions[0], "crank_deg");
    const auto& works = column(result.motions[0], "load_work_J");
    for (std::size_t i = 0; i < works.size(); ++i) {
      const double phi = angles[i] * kPi / 180 - turned;
      EXPECT_NEAR(works[i], energy(0) - energy(phi), 1e-7) << turned << " " << i;
    }
  }
}

TEST(MachineTravel, OfABodyThatTurnsFullyIsCountedWithinItsTurn) {
  // A drag link: in each of its rocker's turns −s does the work −½ (2π)², wherever that begins.
  const MachineResult result = result_of(R"(
mechanism = {type = "four-bar", fixed_pivots = [[0, 0], [1, 0]], crank = 2, coupler = 2.5, rocker = 2}
link = [{name = "crank", inertia = 20}]
load = [{on = "rocker", torque = -1, value = "s"}]
motor = {line = {stall_torque = 20, no_load_speed = 10}}
run = {start_deg = 77}
)");
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_NEAR(quantity(result, "motor_work_J"), kTurn * kPi, 1e-7);
}

TEST(VanishingInertia, IsDistinguishedFromWhatIsSmallAndWhatIsUnknown) {
  const auto place = [](auto inertia) {
    return vanishing_inertia({.move_to =
                                  [=](double phi) {
                                    return machine::EquivalentInertia{inertia(phi), 0};
                                  },
                              .torques = {},
                              .period = kTurn});
  };
  const auto about = [](double phi) { return std::pow(std::sin(0.5 * (phi - 4.321)), 2); };
  EXPECT_NEAR(place(about).value_or(-1), 4.321, 1e-9);
  EXPECT_FALSE(place([&](double phi) { return 1e-6 + about(phi); }));
  const auto unknown_at_ends = [](double phi) {
    return phi < 1e-3 || phi > 6.25 ? std::numeric_limits<double>::quiet_NaN() : 2.0;
  };
  EXPECT_FALSE(place(unknown_at_ends));
  EXPECT_NEAR(place([&](double phi) { return unknown_at_ends(phi) * about(phi); }).value_or(-1),
              4.321, 1e-9);
}

TEST(VanishingInertia, IsNotReportedWhereTheCrankHasSomeHoweverLargeItIsElsewhere) {
  const MachineResult result = result_of(R"(
mechanism = {type = "slider-crank", crank = 1e12, coupler = 4e12}
link = [{name = "crank", inertia = 0.8}, {name = "slider", mass = 1}]
motor = {line = {stall_torque = 20, no_load_speed = 10}}
)");
  EXPECT_FALSE(says(result, "vanishes"));
}

}  // namespace
}  // namespace cognate::problems::machine_travel_test
