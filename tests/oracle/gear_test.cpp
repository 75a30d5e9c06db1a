/// Gears against the worked examples of gears.toml.
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include "analysis/gear/involute.hpp"
#include "analysis/gear/spur_pair.hpp"
#include "analysis/gear/tooth_outline.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/folders.hpp"

namespace cognate::gear_test {
namespace {

using gear::SpurGear;
using gear::SpurPair;

/// One example of the file.
class Example {
 public:
  explicit Example(const char* name)
      : table_(*toml::parse_file(std::string(kOracleFolder) + "/gears.toml")[name].as_table()) {}

  double operator[](const char* key) const { return *table_[key].value<double>(); }

  std::vector<double> column(const char* key) const {
    std::vector<double> values;
    for (const auto& value : *table_[key].as_array()) values.push_back(*value.value<double>());
    return values;
  }

 private:
  toml::table table_;
};

void expect_near(double value, double expected) {
  EXPECT_NEAR(value, expected, 1e-13 * std::max(1.0, std::abs(expected)));
}

TEST(GearOracle, InvoluteFunction) {
  const Example example("involute");
  const auto degrees = example.column("angle_deg");
  const auto involutes = example.column("inv");
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    expect_near(gear::involute(degrees[i] * kDegree), involutes[i]);
    expect_near(gear::involute_angle(involutes[i]), degrees[i] * kDegree);
  }
}

/// The involute of example 5-1 is that of a gear on the same base circle, seen from where its flank
/// would meet that.
TEST(GearOracle, InvolutePoints) {
  const Example example("involute");
  const auto degrees = example.column("point_angle_deg");
  const auto x = example.column("x");
  const auto y = example.column("y");
  SpurGear g{.teeth = 30};
  g.module = example["base_radius"] / base_radius(g);
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const double radius = std::hypot(x[i], y[i]);
    // Half the tooth's angle shrinks by the involute's polar angle. At the base circle that is 0/0.
    const double shrunk =
        i == 0 ? 0 : base_half_angle(g) - tooth_thickness(g, radius) / (2 * radius);
    EXPECT_NEAR(shrunk, std::atan2(x[i], y[i]), 1e-12);
    EXPECT_NEAR(radius * std::cos(degrees[i] * kDegree), base_radius(g), 1e-12 * radius);
  }
}

TEST(GearOracle, InverseInvolute) {
  const Example example("inverse");
  const auto involutes = example.column("inv");
  const auto angles = example.column("angle");
  for (std::size_t i = 0; i < involutes.size(); ++i) {
    expect_near(gear::involute_angle(involutes[i]), angles[i]);
  }
  const double seconds = std::remainder(gear::involute_angle(0.02) / kDegree * 3600, 60);
  EXPECT_NEAR(seconds, 51.96643721444013 - 60, 1e-8);  // and not 51
}

TEST(GearOracle, StandardTooth) {
  const Example example("tooth");
  const SpurGear g{.teeth = example["teeth"], .module = example["module"]};
  expect_near(reference_radius(g), example["reference_radius"]);
  expect_near(base_radius(g), example["base_radius"]);
  expect_near(tip_radius(g), example["tip_radius"]);
  expect_near(root_radius(g), example["root_radius"]);
  expect_near(form_radius(g), example["form_radius"]);
  expect_near(tooth_thickness(g, tip_radius(g)), example["tip_thickness"]);
  EXPECT_FALSE(is_undercut(g));
}

/// The printed flank, where it is involute; below the form circle the flank as cut leaves it.
TEST(GearOracle, FlankOfTheStandardTooth) {
  const Example example("tooth");
  const SpurGear g{.teeth = example["teeth"], .module = example["module"]};
  const auto x = example.column("x");
  const auto y = example.column("y");
  expect_near(std::hypot(x[0], y[0]), example["claimed_radius"]);
  const auto half = tooth_half(g, 1e-9);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec2d printed{x[i], y[i]};
    double nearest = g.module;
    for (std::size_t k = 1; k < half.size(); ++k) {
      const Vec2d chord = half[k].at - half[k - 1].at;
      if (squared_norm(chord) == 0) continue;
      const double share = dot(printed - half[k - 1].at, chord) / squared_norm(chord);
      const Vec2d foot = half[k - 1].at + std::clamp(share, 0.0, 1.0) * chord;
      nearest = std::min(nearest, norm(printed - foot));
    }
    if (norm(printed) > form_radius(g)) {
      EXPECT_LT(nearest, 1e-6) << norm(printed);
    } else {
      EXPECT_GT(nearest, 1e-3) << norm(printed);
    }
  }
}

TEST(GearOracle, PairApart) {
  const Example example("pair");
  const auto teeth = example.column("teeth");
  SpurPair pair{{SpurGear{.teeth = teeth[0], .module = example["module"]},
                 SpurGear{.teeth = teeth[1], .module = example["module"]}},
                example["centre_distance"]};
  const auto result = geometry(pair);
  expect_near(centre_distance_without_backlash(pair.gears), example["standard_distance"]);
  expect_near(result.working_pressure_angle / kDegree, example["working_pressure_angle_deg"]);
  expect_near(result.contact_ratio, example["contact_ratio"]);
  expect_near(result.backlash, example["backlash"]);
  for (std::size_t i = 0; i < 2; ++i) {
    const SpurGear& g = pair.gears[i];
    expect_near(2 * base_radius(g), example.column("base_diameter")[i]);
    expect_near(2 * tip_radius(g), example.column("tip_diameter")[i]);
    expect_near(2 * root_radius(g), example.column("root_diameter")[i]);
    expect_near(pressure_angle(g, tip_radius(g)) / kDegree,
                example.column("tip_pressure_angle_deg")[i]);
    expect_near(2 * result.gears[i].working_radius, example.column("working_diameter")[i]);
    expect_near(result.gears[i].tip_clearance, example["tip_clearance"]);
    EXPECT_EQ(result.gears[i].interference, 0);
  }
  pair.centre_distance = example["standard_distance"];
  expect_near(geometry(pair).contact_ratio, example["contact_ratio_at_standard_distance"]);
  pair.centre_distance = example["distance_of_contact_ratio_1"];
  expect_near(geometry(pair).contact_ratio, 1);
}

TEST(GearOracle, UndercutGear) {
  const Example example("undercut");
  const SpurGear g{.teeth = example["teeth"], .module = example["module"]};
  expect_near(reference_radius(g), example["reference_radius"]);
  expect_near(base_radius(g), example["base_radius"]);
  expect_near(tip_radius(g), example["tip_radius"]);
  expect_near(root_radius(g), example["root_radius"]);
  expect_near(gear::least_teeth(g.rack, 0), example["least_teeth"]);
  expect_near(gear::least_profile_shift(g.rack, g.teeth), example["least_shift"]);
  EXPECT_TRUE(is_undercut(g));
  // The involute does not reach the base circle, as it does in the figure.
  expect_near(form_radius(g), example["form_radius"]);
}

}  // namespace
}  // namespace cognate::gear_test
