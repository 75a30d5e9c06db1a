/// Warnings of designs that no engineer would build, each by a linkage that deserves it and by one
/// that hardly does not.
#include "problems/linkage/oddities.hpp"

#include <gtest/gtest.h>

#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/read.hpp"

namespace cognate::problems::oddities_test {
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

/// The words of the notes on designs of some lengths.
std::string notes_of(const std::vector<Design>& designs,
                     const std::optional<TargetExtent>& target = std::nullopt) {
  Result result;
  result.designs = designs;
  note_oddities(target, result);
  std::string all;
  for (const std::string& note : result.notes) all += note + "\n";
  return all;
}

bool says(const std::string& notes, const char* words) {
  return notes.find(words) != std::string::npos;
}

constexpr Lengths<double> kSound{1, 3, 3, 3.5};

TEST(Oddities, SaysNothingOfASoundLinkage) {
  EXPECT_EQ(notes_of({design_of(kSound)}, TargetExtent{{1, 1}, 0.8}), "");
}

TEST(Oddities, WarnsOfDeadPoints) {
  // B–D is shortest at 2.5 between coupler and rocker of 28.6 and more: 2 asin(2.5/2l) is 5°.
  const double at_limit = 1.25 / std::sin(2.5 * kDegree);
  EXPECT_TRUE(says(notes_of({design_of({1, at_limit * 1.01, at_limit * 1.01, 3.5})}),
                   "Design 1: the transmission angle comes within 5 degrees"));
  EXPECT_FALSE(
      says(notes_of({design_of({1, at_limit * 0.99, at_limit * 0.99, 3.5})}), "transmission"));
}

TEST(Oddities, WarnsOfLinksAndPivotsFarBeyondTheTarget) {
  EXPECT_TRUE(says(notes_of({design_of(kSound)}, TargetExtent{{}, 0.0349}), "a link is more than"));
  EXPECT_FALSE(says(notes_of({design_of(kSound)}, TargetExtent{{}, 0.0351}), "a link is more"));
  const TargetExtent target{{-96, 0}, 1};
  EXPECT_FALSE(says(notes_of({design_of(kSound)}, target), "fixed pivot"));  // D is 99.5 away
  EXPECT_TRUE(says(notes_of({design_of(kSound, {1, 0})}, target), "a fixed pivot lies more"));
  // Where the target was placed is what counts.
  Design placed = design_of(kSound);
  placed.placement = CurvePlacement{0.01, 0, {}};
  EXPECT_TRUE(says(notes_of({placed}, TargetExtent{{}, 1}), "a link is more than"));
}

TEST(Oddities, WarnsOfUnlikeLinksAndOfChangePoints) {
  EXPECT_TRUE(says(notes_of({design_of({0.029, 3, 3, 3})}), "more than 100 times as long as the"));
  EXPECT_FALSE(says(notes_of({design_of({0.031, 3, 3, 3})}), "more than 100 times"));
  // 1 + 4 against 2 + 3.
  EXPECT_TRUE(says(notes_of({design_of({1, 2.003, 3, 4})}), "within a thousandth of a change"));
  EXPECT_FALSE(says(notes_of({design_of({1, 2.005, 3, 4})}), "within a thousandth"));
  EXPECT_FALSE(says(notes_of({design_of({1, 2, 3, 4})}), "within a thousandth"));  // on it
}

TEST(Oddities, NamesAllDesignsAtOnceAndNoneThatMissesAConstraint) {
  const Design odd = design_of({0.01, 3, 3, 3});
  std::vector<Design> designs{odd, design_of(kSound), odd, odd};
  designs[2].constraints.push_back({"class", std::string("a"), std::string("b"), false});
  EXPECT_TRUE(says(notes_of(designs), "Design 1, 4: the longest"));
  EXPECT_TRUE(
      says(notes_of(std::vector<Design>(12, odd)), "Design 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, …: "));
}

/// From a file to the notes: a flat arc whose best path runs along the border of a dead point.
TEST(Oddities, StandInTheResultOfASearch) {
  const auto problem = *parse_task<PathProblem>(
      "kind = \"path-generation\"\n[target]\n"
      "points = [[0, 0], [1, 0.02], [2, 0.03], [3, 0.02], [4, 0]]\n[bounds]\n"
      "length = [300, 900]\n[solve]\nstarts = 40\ndesigns = 1\n");
  const Result result = solve(problem, {.seed = 1});
  ASSERT_EQ(result.status, Status::solved);
  std::string all;
  for (const std::string& note : result.notes) all += note + "\n";
  EXPECT_TRUE(says(all, "Design 1: a link is more than 100 times as long as the target")) << all;
}

/// No crank-rocker of so wide a swing keeps farther than 3.8° from a dead point.
TEST(Oddities, WarnsOfQuickReturnsToo) {
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
  std::string notes;
  for (const std::string& note : result.notes) notes += note + "\n";
  EXPECT_TRUE(says(notes, "the transmission angle comes within 5 degrees")) << notes;
}

}  // namespace
}  // namespace cognate::problems::oddities_test
