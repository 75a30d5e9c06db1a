/// Warnings of designs that no engineer would build, each by a linkage that deserves it and by one
/// that hardly does not.
#include "problems/linkage/warnings.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/read.hpp"

namespace cognate::problems::warnings_test {
namespace {

/// A four-bar with both pivots on the x axis, judged over its whole motion.
Design design_of(const Lengths<double>& links, Vec2d pivot = {}) {
  Design design;
  const FourBar linkage{.pivot_a = pivot,
                        .pivot_d = pivot + Vec2d{links.frame, 0},
                        .crank = links.crank,
                        .coupler = links.coupler,
                        .rocker = links.rocker};
  design.mechanism = named(linkage);
  design.metrics = design_metrics(linkage, std::vector<double>{}, {});
  return design;
}

/// Limits that nothing passes, so that each can be tried by itself.
constexpr WarningLimits kSilent{0, 1e100, 1e100, 1e100, 1e100};

Result warned(const std::vector<Design>& designs, const WarningLimits& limits = {},
              const std::optional<TargetExtent>& target = std::nullopt) {
  Result result;
  result.designs = designs;
  add_warnings(target, limits, result);
  return result;
}

std::string text_of(const std::vector<std::string>& sentences) {
  std::string all;
  for (const std::string& sentence : sentences) all += sentence + "\n";
  return all;
}

/// The words of the warnings of some designs.
std::string warnings_of(const std::vector<Design>& designs, const WarningLimits& limits = {},
                        const std::optional<TargetExtent>& target = std::nullopt) {
  return text_of(warned(designs, limits, target).warnings);
}

bool says(const std::string& warnings, const char* words) {
  return warnings.find(words) != std::string::npos;
}

constexpr Lengths<double> kSound{1, 3, 3, 3.5};

TEST(Warnings, SayNothingOfASoundLinkage) {
  const Result result = warned({design_of(kSound)}, {}, TargetExtent{{1, 1}, 1.6});
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_TRUE(result.designs[0].warnings.empty());
}

TEST(Warnings, OfLowTransmissionAngles) {
  // B–D is shortest at 2.5 between coupler and rocker: 2 asin(2.5/2l).
  const auto with_angle = [](double degrees) {
    const double link = 1.25 / std::sin(0.5 * degrees * kDegree);
    return design_of({1, link, link, 3.5});
  };
  EXPECT_TRUE(says(warnings_of({with_angle(29.9)}),
                   "Design 1: the transmission angle falls below 30 degrees"));
  EXPECT_FALSE(says(warnings_of({with_angle(30.1)}), "transmission"));
  EXPECT_TRUE(says(warnings_of({with_angle(4.9)}),
                   "Design 1: the transmission angle comes within 5 degrees"));
  EXPECT_FALSE(says(warnings_of({with_angle(5.1)}), "comes within"));
  const Result result = warned({with_angle(12.34)});
  EXPECT_TRUE(says(text_of(result.designs[0].warnings),
                   "The transmission angle falls to 12.3 degrees, below 30"));
}

TEST(Warnings, HaveLimitsThatCanBeSet) {
  WarningLimits limits = kSilent;
  const Design design = design_of(kSound);
  const double acute = design.metrics.transmission_acute_min;
  limits.transmission_angle = acute * (1 + 1e-9);
  EXPECT_TRUE(says(warnings_of({design}, limits), "transmission"));
  limits.transmission_angle = acute * (1 - 1e-9);
  EXPECT_EQ(warnings_of({design}, limits), "");
  EXPECT_EQ(warnings_of({design_of({1, 50, 50, 3.5})}, kSilent), "");
}

TEST(Warnings, OfLinksAndPivotsFarBeyondTheTarget) {
  WarningLimits limits = kSilent;
  limits.link_over_target = 10;
  const auto of_link = [&](double size) {
    return warnings_of({design_of(kSound)}, limits, TargetExtent{{}, size});
  };
  EXPECT_TRUE(says(of_link(0.349), "a link is more than 10 times"));
  EXPECT_EQ(of_link(0.351), "");
  // A point far out on a link counts as well.
  Design tracing = design_of(kSound);
  FourBar linkage = *tracing.mechanism.four_bar();
  linkage.coupler_point = Vec2d{3, 4};
  tracing.mechanism = named(linkage);
  EXPECT_TRUE(says(warnings_of({tracing}, limits, TargetExtent{{}, 0.499}), "a link is more"));
  // Where the target was placed is what counts.
  Design placed = design_of(kSound);
  placed.placement = CurvePlacement{0.01, 0, {}};
  EXPECT_TRUE(says(warnings_of({placed}, limits, TargetExtent{{}, 1}), "a link is more than"));

  limits = kSilent;
  limits.pivot_over_target = 100;
  const TargetExtent target{{-96, 0}, 1};  // D is 99.5 away
  EXPECT_EQ(warnings_of({design_of(kSound)}, limits, target), "");
  EXPECT_TRUE(says(warnings_of({design_of(kSound, {1, 0})}, limits, target),
                   "a fixed pivot lies more than 100 times"));
}

TEST(Warnings, TakeTheDiameterOfPoints) {
  const std::vector<Vec2d> ends{{1, 1}, {4, 5}};
  EXPECT_NEAR(extent_of(ends)->size, 5, 1e-14);
  EXPECT_FALSE(extent_of(std::vector<Vec2d>{{1, 1}, {1, 1}}));
}

TEST(Warnings, OfUnlikeLinksAndOfChangePoints) {
  WarningLimits limits = kSilent;
  limits.link_ratio = 20;
  EXPECT_TRUE(says(warnings_of({design_of({0.149, 3, 3, 3})}, limits), "more than 20 times as"));
  EXPECT_EQ(warnings_of({design_of({0.151, 3, 3, 3})}, limits), "");
  // 1 + 4 against 2 + 3.
  EXPECT_TRUE(
      says(warnings_of({design_of({1, 2.003, 3, 4})}, kSilent), "within a thousandth of a change"));
  EXPECT_EQ(warnings_of({design_of({1, 2.005, 3, 4})}, kSilent), "");
  EXPECT_EQ(warnings_of({design_of({1, 2, 3, 4})}, kSilent), "");  // on it
}

TEST(Warnings, OfLinksMuchShorterThanTheCrank) {
  WarningLimits limits = kSilent;
  limits.link_ratio = 20;
  const TargetExtent target{{}, 10};
  const auto with_coupler = [](double coupler) { return design_of({3, coupler, 3.1, 3.2}); };
  EXPECT_TRUE(says(warnings_of({with_coupler(0.149)}, limits, target),
                   "Design 1: the crank is more than 20 times as long as the shortest other"));
  EXPECT_EQ(warnings_of({with_coupler(0.151)}, limits, target), "");
  // Of that is said once, not again of the longest link.
  const Result result = warned({with_coupler(0.01)}, limits);
  EXPECT_EQ(result.designs[0].warnings.size(), 1U);
  EXPECT_TRUE(says(text_of(result.designs[0].warnings), "The crank is 300 times"));
  // So it is of other types, an offset being no link.
  Design slider;
  slider.mechanism = named(SliderCrank{.crank = 3, .coupler = 4, .offset = 0.01});
  EXPECT_EQ(warnings_of({slider}, limits, target), "");
  slider.mechanism = named(SliderCrank{.crank = 3, .coupler = 0.1, .offset = 0.01});
  EXPECT_TRUE(says(warnings_of({slider}, limits, target), "the crank is more than 20 times"));
}

TEST(Warnings, OfBadlyConditionedSyntheses) {
  Design design = design_of(kSound);
  design.metrics.condition = 9.9e3;
  EXPECT_EQ(warnings_of({design}), "");
  design.metrics.condition = 2e4;
  const Result result = warned({design});
  EXPECT_TRUE(says(text_of(result.warnings), "the condition number of the equations is above 1"));
  EXPECT_TRUE(says(text_of(result.designs[0].warnings), "of its equations is 2e+04"));
}

TEST(Warnings, NameAllDesignsAtOnceAndNoneThatMissesAConstraint) {
  const Design odd = design_of({0.01, 3, 3, 3});
  std::vector<Design> designs{odd, design_of(kSound), odd, odd};
  designs[2].constraints.push_back({"class", std::string("a"), std::string("b"), false});
  EXPECT_TRUE(says(warnings_of(designs), "Design 1, 4: the longest"));
  EXPECT_TRUE(warned(designs).designs[2].warnings.empty());
  EXPECT_TRUE(
      says(warnings_of(std::vector<Design>(12, odd)), "Design 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, …: "));
}

TEST(Warnings, AreReadFromEveryKindAndWrittenBack) {
  const auto task = parse_task<PathProblem>(
      "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1, 0.02], [2, 0.03]]\n"
      "[warnings]\ntransmission_angle_deg = 40\nlink_over_target = 5\ncondition = 100\n");
  ASSERT_TRUE(task.has_value());
  EXPECT_NEAR(task->warnings.transmission_angle, 40 * kDegree, 1e-15);
  EXPECT_EQ(task->warnings.link_over_target, 5);
  EXPECT_EQ(task->warnings.pivot_over_target, 10);
  EXPECT_EQ(task->warnings.condition, 100);
  const auto read = reading::read_back(*task);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->warnings.transmission_angle, task->warnings.transmission_angle);
  const auto wrong = parse_task<PathProblem>(
      "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1, 0.02], [2, 0.03]]\n"
      "[warnings]\ntransmission_angle_deg = 91\nlink = 5\n");
  ASSERT_FALSE(wrong.has_value());
  ASSERT_EQ(wrong.error().size(), 2u);
  EXPECT_EQ(wrong.error()[0].line, 5u);
  EXPECT_TRUE(says(wrong.error()[0].message, "an angle in degrees from 0 to 90"));
  EXPECT_TRUE(says(wrong.error()[1].message, "unknown key \"link\" in [warnings]"));
}

/// From a file to the warnings: a flat arc whose best path runs along the border of a dead point.
TEST(Warnings, StandInTheResultOfASearch) {
  const auto problem = *parse_task<PathProblem>(
      "kind = \"path-generation\"\n[target]\n"
      "points = [[0, 0], [1, 0.02], [2, 0.03], [3, 0.02], [4, 0]]\n[bounds]\n"
      "length = [300, 900]\n[solve]\nstarts = 40\ndesigns = 1\n");
  const Result result = solve(problem, {.seed = 1});
  ASSERT_EQ(result.status, Status::solved);
  const std::string all = text_of(result.warnings);
  EXPECT_TRUE(says(all, "Design 1: a link is more than 10 times as long as the target")) << all;
  EXPECT_TRUE(says(text_of(result.designs[0].warnings), "A link is "));
}

/// No crank-rocker of so wide a swing keeps farther than 3.8° from a dead point.
TEST(Warnings, OfQuickReturnsToo) {
  const auto task = parse_task(R"(
kind = "quick-return"
[target]
time_ratio = 1.4
swing_deg = 160
[mechanism]
type = "four-bar"
rocker = 1
)");
  ASSERT_TRUE(task.has_value());
  const Result result = solve(std::get<QuickReturnProblem>(*task), {});
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_LT(result.designs[0].metrics.transmission_acute_min, 5 * kDegree);
  const std::string all = text_of(result.warnings);
  EXPECT_TRUE(says(all, "the transmission angle comes within 5 degrees")) << all;
}

}  // namespace
}  // namespace cognate::problems::warnings_test
