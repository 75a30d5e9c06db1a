/// What results of gear pairs say: distances, limits missed, notes, and how much was searched.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "problems/gear/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "tests/support/gear_pairs.hpp"

namespace cognate::problems::gear_pair_results_test {
namespace {

using test::given_pair;
using test::kAlpha;
using test::quantity;
using test::spur_problem;

bool has_note(const GearPairResult& result, const std::string& part) {
  return std::ranges::any_of(
      result.notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

std::vector<std::string> missed(const GearPairDesign& design) {
  std::vector<std::string> names;
  for (const auto& check : design.constraints) {
    if (!check.satisfied) names.push_back(check.name);
  }
  return names;
}

GearPairProblem free_pair(int z1, int z2, double module) {
  GearPairProblem problem;
  problem.teeth = {z1, z2};
  problem.module = module;
  return problem;
}

// Of undercut pinions the form circles limit the path at first: it grows with the distance.
TEST(GearPairResults, TellsTheDistancesAtWhichAPairDrivesContinuously) {
  int tested = 0;
  for (const int teeth : {8, 10, 11, 14, 20}) {
    const double closest = 2.0 * teeth;
    double greatest = 0;
    for (int i = 0; i <= 1500; ++i) {
      const double distance = closest + 2e-3 * i;
      const auto result = solve(given_pair(teeth, teeth, 2, distance), {});
      const double ratio = quantity(result.designs[0].metrics, "contact_ratio");
      if (ratio >= 1) greatest = distance;
    }
    for (const double distance : {closest, closest + 0.3, closest + 3}) {
      const auto result = solve(given_pair(teeth, teeth, 2, distance), {});
      const auto& metrics = result.designs[0].metrics;
      if (quantity(metrics, "contact_ratio") >= 1) continue;
      EXPECT_EQ(has_note(result, "at every centre distance"), greatest == 0) << teeth;
      if (greatest == 0) continue;
      ++tested;
      EXPECT_NEAR(quantity(metrics, "continuous_centre_distance_max"), greatest, 3e-3) << teeth;
    }
  }
  EXPECT_GE(tested, 7);
}

TEST(GearPairResults, RefusesTeethWhoseBaseCirclesOverlap) {
  GearPairProblem problem;
  problem.centre_distance = 100;
  problem.module = 2;
  problem.teeth_bounds = {{{55, 80}, {40, 80}}};
  int overlapping = 0;
  for (int z1 = 55; z1 <= 80; ++z1) {
    for (int z2 = 40; z2 <= 80; ++z2) overlapping += (z1 + z2) * std::cos(kAlpha) >= 100 ? 1 : 0;
  }
  const auto result = solve(problem, {});
  EXPECT_GE(quantity(result.quantities, "refused_by_centre_distance"), overlapping);
  problem.teeth_bounds = {{{60, 80}, {60, 80}}};
  const auto none = solve(problem, {});
  EXPECT_EQ(quantity(none.quantities, "refused_by_centre_distance"), 441);
  ASSERT_EQ(none.designs.size(), 1u);
  EXPECT_EQ(none.designs[0].settled.teeth[0], 60);
  EXPECT_TRUE(has_note(none, "base circles overlap"));
  EXPECT_FALSE(has_note(none, "greater shifts"));
  GearPairProblem bounded = free_pair(20, 40, 2);
  bounded.centre_distance_bounds = {0, 10};
  const auto near = solve(bounded, {});
  EXPECT_EQ(quantity(near.quantities, "refused_by_centre_distance"), 1);
  ASSERT_EQ(near.designs.size(), 1u);
  EXPECT_EQ(missed(near.designs[0]), std::vector<std::string>{"bounds.centre_distance"});
}

TEST(GearPairResults, TheNearestPairMissesNothingElseNeedlessly) {
  using Names = std::vector<std::string>;
  GearPairProblem ratio;
  ratio.module = 2;
  ratio.teeth_bounds = {{{20, 30}, {20, 30}}};
  ratio.ratio = 7;
  const auto far = solve(ratio, {});
  ASSERT_EQ(far.designs.size(), 1u);
  EXPECT_EQ(missed(far.designs[0]), Names{"target.ratio_tolerance"});
  EXPECT_EQ(far.notes,
            Names{"The nearest ratio is 1.5; 7 was requested, with a relative tolerance of "
                  "0."});
  GearPairProblem contact = free_pair(20, 40, 2);
  contact.constraints.contact_ratio_min = 3;
  const auto long_path = solve(contact, {});
  EXPECT_EQ(missed(long_path.designs.at(0)), Names{"contact_ratio_min"});
  GearPairProblem apart = free_pair(20, 40, 2);
  apart.centre_distance_bounds = {100, 200};
  const auto bounded = solve(apart, {});
  EXPECT_EQ(missed(bounded.designs.at(0)), Names{"bounds.centre_distance"});
  EXPECT_LE(*bounded.designs[0].settled.profile_shift[0], 1.2);
  GearPairProblem given = free_pair(20, 40, 2);
  given.centre_distance = 100;
  const auto shifts = *solve(given, {}).designs.at(0).settled.profile_shift[0];
  EXPECT_LE(shifts, 1.2);
}

// Nothing but the module is a length: a pair of another one is the same, scaled.
TEST(GearPairResults, ScaledCopiesAreSearchedOnce) {
  GearPairProblem problem = spur_problem(GearObjective::contact_ratio);
  problem.teeth = {12, 31};
  problem.modules = {1, 1.5, 2, 3, 7};
  const auto result = solve(problem, {});
  ASSERT_EQ(result.designs.size(), 1u);
  EXPECT_EQ(result.designs[0].settled.module, 1);
  EXPECT_EQ(quantity(result.quantities, "combinations"), 5);
  EXPECT_EQ(quantity(result.quantities, "scaled_copies"), 4);
  // Bounds that nothing reaches make lengths of them: the ties are then the smaller pair's.
  problem.centre_distance_bounds = {1, 1e6};
  problem.solve.designs = 5;
  const auto tied = solve(problem, {});
  ASSERT_EQ(tied.designs.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(tied.designs[i].settled.module, problem.modules[i]);
    EXPECT_NEAR(*tied.designs[i].settled.centre_distance / *tied.designs[i].settled.module,
                *result.designs[0].settled.centre_distance, 1e-6);
  }
}

TEST(GearPairResults, OfManyCombinationsNoneThatIsSearchedAloneIsBetter) {
  int tested = 0;
  GearPairProblem problem = spur_problem(GearObjective::balanced_sliding);
  problem.teeth_bounds = {{{12, 40}, {20, 110}}};
  problem.modules = {2};
  const auto result = solve(problem, {});
  ASSERT_EQ(result.designs.size(), 3u);
  EXPECT_EQ(quantity(result.quantities, "combinations_searched_coarsely"), 29 * 91);
  EXPECT_EQ(quantity(result.quantities, "combinations_searched"), 100);
  const double best = quantity(result.designs[0].metrics, "sliding_max");
  for (int z1 = 12; z1 <= 40; z1 += 7) {
    for (int z2 = 20; z2 <= 110; z2 += 15) {
      GearPairProblem alone = problem;
      alone.teeth = {z1, z2};
      const auto single = solve(alone, {});
      if (single.status != Status::solved) continue;
      ++tested;
      EXPECT_GE(quantity(single.designs[0].metrics, "sliding_max"), best - 1e-9) << z1 << ' ' << z2;
    }
  }
  EXPECT_GE(tested, 31);
}

TEST(GearPairResults, ARunThatIsCutSaysSoAndHasSeenSomeOfAllSizes) {
  GearPairProblem problem = spur_problem(GearObjective::balanced_sliding);
  problem.teeth_bounds = {{{12, 40}, {20, 110}}};
  problem.modules = {2};
  std::atomic<bool> stop{false};
  const auto progress = [&](double share, double) { stop = share > 0.008; };
  const auto cut = solve(problem, {.threads = 1, .interrupted = &stop, .progress = progress});
  EXPECT_EQ(cut.status, Status::interrupted);
  EXPECT_EQ(cut.designs.size(), 3u);
  EXPECT_TRUE(has_note(cut, " of 2639 combinations had been looked at"));
  EXPECT_LT(quantity(cut.quantities, "combinations_searched_coarsely"), 80);
  EXPECT_EQ(quantity(cut.quantities, "combinations_searched"), 0);
  EXPECT_GT(*cut.designs[0].settled.teeth[0], 30);  // those of many teeth slide least
}

TEST(GearPairResults, HelicalTipsAndPlayAreMeasuredAcrossTheTeeth) {
  GearPairProblem problem;
  problem.gearing = Gearing::helical;
  problem.helix = 40 * kPi / 180;
  problem.teeth = {14, 40};
  problem.module = 2;
  problem.constraints.tip_thickness_min = 0.6;
  const auto result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  for (const std::string gear : {"pinion.", "wheel."}) {
    const auto of = [&](const char* name) {
      return quantity(result.designs[0].metrics, gear + name);
    };
    // The tip's helix by its lead: an arc of the section is cut at that angle.
    const double slope = kPi * of("tip_diameter") / of("lead");
    const double across = of("tip_thickness") / std::sqrt(1 + slope * slope);
    EXPECT_NEAR(of("normal_tip_thickness"), across, 1e-12);
    EXPECT_GE(across, 0.6 * 2 - 1e-9);
  }
  // ISO 21771: j_bn = j_wt cos α_wt cos β_b, computed by hand.
  GearPairProblem given = given_pair(38, 78, 1, 68.058);
  given.gearing = Gearing::helical;
  given.helix = kPi / 6;
  given.profile_shift = {0.471, 0.648};
  EXPECT_NEAR(quantity(solve(given, {}).designs[0].metrics, "normal_backlash"), 0.0095687, 5e-8);
}

// cos β = m_n (z₁ + z₂)/(2 a): the design of every textbook, 23 and 96 teeth of module 2 at 122.
TEST(GearPairResults, TheHelixIsThatOfTheCentreDistance) {
  const auto read = parse_task<GearPairProblem>(
      "kind = \"gear-pair\"\n[mechanism]\ngearing = \"helical\"\nteeth = [23, 96]\nmodule = 2\n"
      "profile_shift = [0, 0]\ncentre_distance = 122\nhelix_deg = \"free\"");
  ASSERT_TRUE(read);
  const auto result = solve(*read, {});
  ASSERT_EQ(result.status, Status::solved);
  const auto& metrics = result.designs[0].metrics;
  EXPECT_NEAR(quantity(metrics, "helix_deg"), 12.7325, 1e-4);  // 12°43′57″
  EXPECT_NEAR(std::cos(quantity(metrics, "helix_deg") * kPi / 180), 119.0 / 122, 1e-14);
  EXPECT_NEAR(quantity(metrics, "backlash"), 0, 1e-12);
  EXPECT_NEAR(quantity(metrics, "pinion.reference_diameter") +
                  quantity(metrics, "wheel.reference_diameter"),
              244, 1e-12);
  EXPECT_FALSE(result.designs[0].settled.free_helix);
}

// Planted: the distance of a pair with helix, shifts and backlash leads back to its helix.
TEST(GearPairResults, AHelixIsFoundAgainFromItsDistance) {
  std::mt19937_64 random(7);
  const auto within = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  for (int i = 0; i < 200; ++i) {
    GearPairProblem planted = given_pair(int(within(12, 60)), int(within(20, 120)), 2.5, 0);
    planted.gearing = Gearing::helical;
    planted.helix = within(0.5, 60) * kPi / 180;
    planted.profile_shift = {within(-0.3, 0.8), within(-0.3, 0.8)};
    planted.backlash = i % 2 == 0 ? 0 : within(0, 0.3);
    planted.centre_distance.reset();
    const auto forward = solve(planted, {});
    ASSERT_EQ(forward.designs.size(), 1u);
    GearPairProblem asked = planted;
    asked.centre_distance = quantity(forward.designs[0].metrics, "centre_distance");
    asked.free_helix = true;
    asked.helix = 0;
    const auto back = solve(asked, {});
    ASSERT_EQ(back.designs.size(), 1u);
    EXPECT_NEAR(back.designs[0].settled.helix, planted.helix, 1e-9) << i;
  }
}

TEST(GearPairResults, TheTextbooksTableOfATooth) {
  GearProblem problem;
  problem.gear.normal.teeth = 35;
  problem.gear.normal.module = 4;
  problem.gear.normal.profile_shift = 0.3;
  const auto of = [metrics = analyse(problem, {}).metrics](const char* name) {
    return quantity(metrics, name);
  };
  const double alpha = kPi / 9, thickness = 4 * (kPi / 2 + 2 * 0.3 * std::tan(alpha));
  EXPECT_NEAR(of("pitch"), 4 * kPi, 1e-12);
  EXPECT_NEAR(of("base_pitch"), 4 * kPi * std::cos(alpha), 1e-12);
  EXPECT_NEAR(of("tooth_thickness"), thickness, 1e-12);
  EXPECT_NEAR(of("space_width"), 4 * kPi - thickness, 1e-12);
  EXPECT_NEAR(of("addendum"), 4 * 1.3, 1e-12);
  EXPECT_NEAR(of("dedendum"), 4 * 0.95, 1e-12);
  EXPECT_NEAR(of("tooth_depth"), 4 * 2.25, 1e-12);
  // s_b = cos α (s + d inv α)
  EXPECT_NEAR(of("base_thickness"), std::cos(alpha) * (thickness + 140 * (std::tan(alpha) - alpha)),
              1e-12);
}

// The wheel of a worm is, in its middle plane, the gear that kind = "gear" makes of its numbers.
TEST(GearPairResults, AWormWheelIsJudgedAsTheGearThatItIs) {
  int impossible = 0;
  for (const int teeth : {3, 12, 40}) {
    for (double shift = -10; shift <= 10; shift += 0.5) {
      GearPairProblem problem;
      problem.gearing = Gearing::worm;
      problem.module = 2;
      problem.worm.wheel_teeth = teeth;
      problem.worm.module = 2;
      problem.worm.wheel_shift = shift;
      const auto result = solve(problem, {});
      GearProblem alone;
      alone.gear.normal = {.teeth = double(teeth), .module = 2, .profile_shift = shift};
      const bool sound = analyse(alone, {}).status == Status::solved;
      EXPECT_EQ(result.status == Status::solved, sound) << teeth << ' ' << shift;
      EXPECT_EQ(result.notes.empty(), sound);
      impossible += sound ? 0 : 1;
    }
  }
  EXPECT_GT(impossible, 60);
}

TEST(GearPairResults, NotesTellWhatIsAllowedAndWhatIsInfinite) {
  GearPairProblem touching = given_pair(40, 40, 2, 0);
  touching.centre_distance.reset();
  touching.profile_shift = {-0.5, -0.5};
  touching.constraints.no_interference = false;
  const auto result = solve(touching, {});
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_TRUE(has_note(result, "Allowed by no_interference = false: The wheel's tips interfere"));
  GearPairProblem cut = given_pair(12, 60, 2, 72);
  cut.constraints.no_undercut = false;
  EXPECT_TRUE(has_note(solve(cut, {}), "Allowed by no_undercut = false: The pinion is undercut"));
  // With the least shift the involute begins on the base circle, where the wheel's tips reach.
  GearPairProblem least = given_pair(12, 60, 2, 72);
  least.profile_shift = {1 - 6 * std::sin(kAlpha) * std::sin(kAlpha) - 5e-16, -0.6};
  least.centre_distance.reset();
  EXPECT_TRUE(has_note(solve(least, {}), "sliding of the pinion is infinite"));
}

TEST(GearPairResults, BevelGearsWhoseConesAreNearlyFlatAreSound) {
  GearPairProblem problem;
  problem.gearing = Gearing::bevel;
  problem.teeth = {20, 40};
  problem.module = 2;
  for (double less = 1e-1; less > 1e-9; less *= 0.3) {  // at 120° the wheel would be a face gear
    problem.shaft_angle = (120 - less) * kPi / 180;
    EXPECT_EQ(solve(problem, {}).status, Status::solved) << less;
  }
  problem.teeth = {10, 40};
  problem.shaft_angle = kRightAngle;
  const auto cut = solve(problem, {});
  EXPECT_TRUE(has_note(cut, "10 teeth on its cone (a virtual gear of 10.3078)"));
  EXPECT_TRUE(has_note(cut, "at least 17 teeth on the same cone"));
}

}  // namespace
}  // namespace cognate::problems::gear_pair_results_test
