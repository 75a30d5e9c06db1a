// Extremes of forces: a short run of the random linkages, and files whose rows missed them.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/read.hpp"
#include "tests/stress/force_brute.hpp"

namespace cognate::problems {
namespace {

AnalysisResult result_of(const std::string& text) {
  const auto problem = parse_task<AnalysisProblem>("kind = \"analysis\"\n" + text);
  EXPECT_TRUE(problem) << (problem ? "" : problem.error().front().message);
  return problem ? analyse(*problem, Run{.threads = 1}) : AnalysisResult{};
}

std::map<std::string, double> numbers(const AnalysisResult& result) {
  std::map<std::string, double> all;
  for (const Quantity& quantity : result.quantities) {
    if (const auto* value = std::get_if<double>(&quantity.value)) all[quantity.name] = *value;
  }
  return all;
}

TEST(ForceExtremes, AgreeWithBruteForce) {
  const auto tally = stress::check_forces(7, 60);
  EXPECT_EQ(tally.linkages, 60);
  EXPECT_GT(tally.bounded, 200);
  EXPECT_GT(tally.unbounded, 40);
  EXPECT_GT(tally.reactions, 160);
  EXPECT_EQ(tally.disagreements, 0) << tally.first_file;
}

TEST(ForceExtremes, OfALoadBetweenTwoRowsAreThoseOfItsInterval) {
  const auto quantities = numbers(result_of(R"(
mechanism = {type = "slider-crank", crank = 0.1, coupler = 0.3}
load = [{on = "slider", force = [-1000, 0], when = [40.2, 40.8]}]
drive = {speed = 10, steps = 360}
)"));
  // |F| · |ds/dφ|, which grows with the angle there.
  const double angle = 40.8 * kDegree, sine = std::sin(angle), cosine = std::cos(angle);
  const double rate = 0.1 * sine * (1 + 0.1 * cosine / std::sqrt(0.09 - 0.01 * sine * sine));
  EXPECT_NEAR(quantities.at("torque_N_m.min"), -1000 * rate, 1e-9);
  EXPECT_NEAR(quantities.at("torque_N_m.min_at_deg"), 40.8, 1e-9);
  EXPECT_EQ(quantities.at("torque_N_m.max"), 0);
  EXPECT_NEAR(quantities.at("reaction_max_N.C_on_slider"), 1000 / std::sqrt(1 - sine * sine / 9),
              1e-9);
}

TEST(ForceExtremes, AreUnboundedNearADeadPoint) {
  for (const int steps : {3, 360, 3600})  // of three steps no row closes
  {
    const AnalysisResult result = result_of(R"(
gravity = [0, -9.81]
mechanism = {type = "four-bar", fixed_pivots = [[0, 0], [0.3, 0]], crank = 0.25, coupler = 0.28, rocker = 0.1}
link = [{between = ["B", "C"], mass = 2, centre = [0.14, 0], inertia = 0.02}]
load = [{on = "rocker", torque = -5}]
drive = {speed = 3, steps = )" + std::to_string(steps) +
                                            "}\n");
    const auto quantities = numbers(result);
    // BD is the difference of coupler and rocker: cos φ = (0.25² + 0.3² − 0.18²)/(2 · 0.25 · 0.3).
    const double dead = std::acos((0.0625 + 0.09 - 0.0324) / 0.15) / kDegree;
    EXPECT_NEAR(quantities.at("torque_N_m.min_unbounded_at_deg"), dead, 1e-9);
    EXPECT_NEAR(quantities.at("reaction_max_unbounded_at_deg.A_on_crank"), dead, 1e-9);
    for (const char* gone : {"torque_N_m.min", "torque_N_m.max", "reaction_max_N.A_on_crank"}) {
      EXPECT_FALSE(quantities.contains(gone)) << gone;
    }
    EXPECT_TRUE(std::ranges::any_of(result.notes, [](const std::string& note) {
      return note.find("grows without bound near the dead point at 86.9045°") != note.npos;
    }));
  }
}

TEST(ForceExtremes, DoNotDependOnTheTable) {
  const auto press = [](int steps) {
    return numbers(result_of(R"(
mechanism = {type = "slider-crank", crank = 0.1, coupler = 0.35, offset = 0.02}
link = [{name = "slider", mass = 4}, {name = "coupler", mass = 2, centre = [0.1, 0], inertia = 0.02}]
load = [{on = "slider", force = [-900, 0], when = "advance", stroke = [0.6, 1]}]
drive = {speed = 12, steps = )" +
                             std::to_string(steps) + "}\n"));
  };
  const auto coarse = press(3), fine = press(20000);
  int compared = 0;
  for (const auto& [name, value] : fine) {
    if (name.find("torque") == name.npos && name.find("reaction") == name.npos) continue;
    if (name.find("_at_deg") != name.npos) continue;
    EXPECT_NEAR(coarse.at(name), value, 1e-9 * std::abs(value)) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 8);
}

TEST(ForceExtremes, OfADrivenSliderHaveTheirPlaceAsALength) {
  const auto quantities = numbers(result_of(R"(
[mechanism]
type = "chain"
pivot = [{name = "A", at = [0, 0]}]
slider = {slide = {through = [0, 0], direction_deg = 0}, pin = "C", name = "piston"}
[[mechanism.dyad]]
type = "RRR"
joins = ["C", "A"]
lengths = [0.3, 0.1]
new = "B"
names = ["rod", "crank"]
[[load]]
on = "crank"
torque = -10
[drive]
start = 0.21
end = 0.39
)"));
  // With x the slider's place, cos φ = (x² − 0.08)/(0.2 x) and |F| = 10 dφ/dx.
  double least = HUGE_VAL, at = 0;
  constexpr int kSamples = 200000;
  for (int i = 0; i <= kSamples; ++i) {
    const double x = 0.21 + 0.18 * i / kSamples, cosine = (x * x - 0.08) / (0.2 * x);
    const double slope = 0.5 * (10 + 0.8 / (x * x)) / std::sqrt(1 - cosine * cosine);
    if (10 * slope < least) least = 10 * slope, at = x;
  }
  EXPECT_NEAR(quantities.at("drive_force_N.min"), least, 1e-8 * least);
  EXPECT_NEAR(quantities.at("drive_force_N.min_at"), at, 1e-6);
}

}  // namespace
}  // namespace cognate::problems
