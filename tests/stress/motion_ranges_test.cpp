// Swings, strokes, classes, dead points and transmission: a short run of the random mechanisms, and
// files that were answered wrongly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/read.hpp"
#include "tests/stress/ranges/range_stress.hpp"

namespace cognate::problems {
namespace {

AnalysisResult result_of(const std::string& mechanism, const std::string& drive) {
  const auto problem = parse_task<AnalysisProblem>("kind = \"analysis\"\n[mechanism]\n" +
                                                   mechanism + "\n[drive]\nsteps = 12\n" + drive);
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

bool notes_hold(const AnalysisResult& result, const std::string& text) {
  return std::ranges::any_of(
      result.notes, [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(MotionRanges, OfOneLoopAgreeWithBruteForce) {
  const auto tally = stress::check_loops(3, 80);
  EXPECT_EQ(tally.mechanisms, 80);
  EXPECT_GT(tally.at_ties, 5);
  EXPECT_GT(tally.near_ties, 10);
  EXPECT_GT(tally.several_ranges, 15);
  EXPECT_GT(tally.come_round, 2);
  EXPECT_GT(tally.turn, 2);
  EXPECT_EQ(tally.classes.size(), 5);
  EXPECT_GT(tally.all_compared(), 600);
  for (const auto& [name, file] : tally.first) ADD_FAILURE() << file;
}

TEST(MotionRanges, OfSixBarsAgreeWithBruteForce) {
  const auto tally = stress::check_chains(3, 40);
  EXPECT_EQ(tally.mechanisms, 40);
  EXPECT_GT(tally.several_ranges, 15);
  EXPECT_EQ(tally.all_compared(), 200);
  for (const auto& [name, file] : tally.first) ADD_FAILURE() << file;
}

TEST(MotionRanges, ADriveThatCrossesSeveralRangesIsNoted) {
  // A double-rocker that closes from 17.1° to 56.3° and from −56.3° to −17.1°.
  const std::string links =
      "type = \"four-bar\"\nfixed_pivots = [[0, 0], [5, 0]]\ncrank = 4.5\ncoupler = 1.5\n"
      "rocker = 3\n";
  const auto several = result_of(links, "start_deg = 30\nend_deg = 390");
  EXPECT_TRUE(notes_hold(several, "the drive crosses 3 separate ranges of the mechanism"));
  const auto all = numbers(several);
  EXPECT_EQ(all.at("transmission_angle_deg.min"), 0);
  EXPECT_EQ(all.at("transmission_angle_deg.max"), 180);
  // Of a part of one range cos μ = (1.5² + 3² − d²)/9, d² = 5² + 4.5² − 45 cos θ.
  const auto one = result_of(links, "start_deg = 30\nend_deg = 50");
  EXPECT_FALSE(notes_hold(one, "crosses"));
  const double square = 25 + 20.25 - 45 * std::cos(30 / kDegreesInRadian);
  EXPECT_NEAR(numbers(one).at("transmission_angle_deg.min"),
              kDegreesInRadian * std::acos((11.25 - square) / 9), 1e-9);
}

TEST(MotionRanges, AStrokeThatGoesToInfinityIsNone) {
  const std::string generator = "type = \"tangent-generator\"\noffset = 2\n";
  const auto endless = result_of(generator, "start_deg = 0\nend_deg = 360");
  EXPECT_FALSE(numbers(endless).contains("output_stroke"));
  EXPECT_TRUE(notes_hold(endless, "the stroke of slider has no end"));
  const auto bounded = result_of(generator, "start_deg = 45\nend_deg = 135");
  EXPECT_NEAR(numbers(bounded).at("output_stroke"), 4, 1e-12);
  EXPECT_FALSE(notes_hold(bounded, "has no end"));
}

TEST(MotionRanges, DeadPointsNextToAChangePointAreTwo) {
  // Crank and coupler exceed rocker and frame by 2e-14: the crank stops 1.7e-5° before A–D.
  const auto result = result_of(
      "type = \"four-bar\"\nfixed_pivots = [[0, 0], [1.0625, 0]]\ncrank = 1.2968750000000251\n"
      "coupler = 1.296875\nrocker = 1.0625",
      "");
  const auto dead = std::ranges::count(result.landmarks, "dead point", &Landmark::kind);
  const auto change = std::ranges::count(result.landmarks, "change point", &Landmark::kind);
  EXPECT_EQ(dead, 2);
  EXPECT_EQ(change, 0);
}

TEST(MotionRanges, TransmissionNextToAChangePointKeepsItsDigits) {
  // Of a parallelogram whose frame is longer by 10⁻³ … 10⁻¹³: at θ = 0 cos μ = (l₂² + l₃² − d²)/(2
  // l₂ l₃) with d = frame − 1 and coupler − rocker = 3, so that 4 l₂ l₃ sin²(μ/2) = d² − 9.
  int compared = 0;
  for (int power = 3; power <= 13; ++power) {
    const double frame = 4 + std::pow(10, -power), over = frame - 4;
    const Lengths<double> links{1, 4, 1, frame};
    const double expected = 2 * std::asin(std::sqrt(over * (6 + over) / 16));
    const TransmissionAngles angles = transmission_angles(links, {-1, 1});
    EXPECT_NEAR(angles.min / expected, 1, 1e-12) << power;
    ++compared;
  }
  EXPECT_EQ(compared, 11);
  EXPECT_EQ(transmission_angles(Lengths<double>{1, 4, 1, 4}).min, 0);
  EXPECT_EQ(transmission_angles(Lengths<double>{1, 4, 1, 4 + 4e-15}).acute_min, 0);
}

}  // namespace
}  // namespace cognate::problems
