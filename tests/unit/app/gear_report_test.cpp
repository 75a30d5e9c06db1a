// What the report of gears draws, held against what is known of them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "app/report/gear_report_data.hpp"
#include "tests/browser/sample_gears.hpp"

namespace cognate::app::gear_report_test {
namespace {

using nlohmann::ordered_json;

struct Report {
  ordered_json operator()(const problems::GearProblem& problem) const {
    return gear_report_data(problem, analyse(problem, {.threads = 1}));
  }
  ordered_json operator()(const problems::GearPairProblem& problem) const {
    return gear_pair_report_data(problem, solve(problem, {.threads = 1}));
  }
};

/// The first design that the page of a sample draws.
ordered_json design_of(const std::string& name) {
  for (const auto& sample : problems::sample_gears()) {
    if (sample.name == name) return std::visit(Report{}, sample.problem)["designs"][0];
  }
  ADD_FAILURE() << name;
  return {};
}

/// Length of the path of contact over the base pitch.
double contact_ratio(const ordered_json& design) {
  const auto& pinion = design["gears"][0];
  const double base_pitch = 2 * kPi * pinion["base"].get<double>() / pinion["teeth"].get<double>();
  return (design["path_end"].get<double>() - design["path_start"].get<double>()) / base_pitch;
}

// Li & Xu 2011, examples 5-1 and 5-2.
TEST(GearReport, PathOfContactIsThatOfTheBook) {
  EXPECT_NEAR(contact_ratio(design_of("pair")), 1.691, 5e-4);
  EXPECT_NEAR(contact_ratio(design_of("lost")), 0.765, 5e-4);
}

TEST(GearReport, HalfAToothGoesFromTheRootsMiddleToTheTips) {
  for (const auto& [name, teeth] : {std::pair("gear", 35), std::pair("undercut", 9)}) {
    const ordered_json half = design_of(name)["gears"][0]["half"];
    const auto x = half["x"].get<std::vector<double>>(), y = half["y"].get<std::vector<double>>();
    ASSERT_EQ(x.size(), y.size());
    ASSERT_EQ(x.size(), half["part"].size());
    EXPECT_NEAR(std::atan2(-x.front(), y.front()), kPi / teeth, 1e-5);
    EXPECT_NEAR(std::hypot(x.front(), y.front()), 2.5 * teeth - 6.25, 1e-4);
    EXPECT_NEAR(x.back(), 0, 1e-9);
    EXPECT_NEAR(y.back(), 2.5 * teeth + 5, 1e-4);
  }
}

TEST(GearReport, RackIsOnePitchWithItsFlanksAtThePressureAngle) {
  const ordered_json rack = design_of("gear")["gears"][0]["rack"];
  const auto x = rack["x"].get<std::vector<double>>(), y = rack["y"].get<std::vector<double>>();
  EXPECT_GT(x.front(), -kPi * 2.5);
  EXPECT_LT(x.back(), kPi * 2.5);
  double longest = 0, slope = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    EXPECT_GT(x[i], x[i - 1]);
    const double length = std::hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
    if (length <= longest || std::abs(y[i] - y[i - 1]) < 1) continue;
    longest = length;
    slope = std::abs((x[i] - x[i - 1]) / (y[i] - y[i - 1]));
  }
  EXPECT_NEAR(slope, std::tan(kPi / 9), 1e-4);
}

TEST(GearReport, ConesAndWormAreThoseOfTheirFormulas) {
  const ordered_json cones = design_of("bevel")["cones"];
  EXPECT_NEAR(std::tan(cones["gears"][0]["cone_angle"].get<double>()), 0.5, 1e-5);
  EXPECT_NEAR(cones["cone_distance"].get<double>(), 2.5 * std::hypot(20, 40), 1e-3);
  const ordered_json worm = design_of("worm")["worm"];
  EXPECT_EQ(worm["centre_distance"], 100);
  EXPECT_EQ(worm["reference"], 20);
}

TEST(GearReport, GearsThatCannotBeMadeHaveNoOutline) {
  problems::GearProblem problem;
  problem.gear.normal.teeth = 9;
  problem.gear.normal.rack.addendum = 3;
  const ordered_json data = gear_report_data(problem, analyse(problem, {.threads = 1}));
  EXPECT_TRUE(data["designs"][0]["gears"][0]["half"]["x"].empty());
}

}  // namespace
}  // namespace cognate::app::gear_report_test
