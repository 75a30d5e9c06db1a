/// Gear pairs found, against textbook formulas written out here and every pair of a fine grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/gear/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "tests/support/gear_pairs.hpp"

namespace cognate::problems::gear_pair_search_test {
namespace {

using test::given_pair;
using test::kAlpha;
using test::quantity;
using test::spur_problem;

double inv(double angle) {
  return std::tan(angle) - angle;
}

/// A spur pair of the standard rack by Li & Xu 2011, chapter 5, and ISO 21771.
struct Textbook {
  int z1, z2;
  double m, x1, x2, a;

  double rb(int z) const { return 0.5 * m * z * std::cos(kAlpha); }
  double ra(int z, double x) const { return m * (0.5 * z + 1 + x); }
  double working() const { return std::acos((rb(z1) + rb(z2)) / a); }
  double tangent(int z, double x) const { return std::sqrt(ra(z, x) * ra(z, x) - rb(z) * rb(z)); }

  double contact_ratio() const {
    const double t1 = tangent(z1, x1) / rb(z1), t2 = tangent(z2, x2) / rb(z2);
    const double t = std::tan(working());
    return (z1 * (t1 - t) + z2 * (t2 - t)) / (kTurn);
  }
  /// Where the wheel's tip touches the pinion, from the pinion's base tangent; and the reverse.
  double foot1() const { return a * std::sin(working()) - tangent(z2, x2); }
  double foot2() const { return a * std::sin(working()) - tangent(z1, x1); }
  double sliding1() const { return 1 - tangent(z2, x2) * z1 / (foot1() * z2); }
  double sliding2() const { return 1 - tangent(z1, x1) * z2 / (foot2() * z1); }
  double sliding() const {
    if (foot1() <= 0 || foot2() <= 0) return HUGE_VAL;
    return std::max(std::abs(sliding1()), std::abs(sliding2()));
  }
  double thickness(int z, double x, double radius) const {
    const double s = m * (kRightAngle + 2 * x * std::tan(kAlpha));
    return radius * (s / (0.5 * m * z) + 2 * (inv(kAlpha) - inv(std::acos(rb(z) / radius))));
  }
  double tip_thickness() const {
    return std::min(thickness(z1, x1, ra(z1, x1)), thickness(z2, x2, ra(z2, x2))) / m;
  }
  double backlash() const {
    const double r1 = a * z1 / (z1 + z2), r2 = a - r1;
    return kTurn * r1 / z1 - thickness(z1, x1, r1) - thickness(z2, x2, r2);
  }
  double clearance() const { return a / m - 0.5 * (z1 + z2) - (x1 + x2) + 0.25; }
  bool is_undercut() const {
    const double share = 0.5 * std::sin(kAlpha) * std::sin(kAlpha);
    return x1 < 1 - z1 * share - 1e-12 || x2 < 1 - z2 * share - 1e-12;
  }
  bool interferes() const {
    const auto form = [&](int z, double x) {
      return 0.5 * m * z * std::sin(kAlpha) - m * (1 - x) / std::sin(kAlpha);
    };
    const double slack = 2e-9 * m;
    return foot1() < form(z1, x1) - slack || foot2() < form(z2, x2) - slack;
  }
  /// Within the limits that `limits` sets.
  bool is_sound(const GearConstraints& limits) const {
    constexpr double kSlack = 1e-9;
    return contact_ratio() >= limits.contact_ratio_min - kSlack &&
           tip_thickness() >= limits.tip_thickness_min - kSlack && !is_undercut() &&
           !interferes() && clearance() >= limits.tip_clearance_min.value_or(0) - kSlack;
  }
  double objective(GearObjective wanted) const {
    if (wanted == GearObjective::size) return a;
    return wanted == GearObjective::contact_ratio ? -contact_ratio() : sliding();
  }
};

Textbook textbook(const GearPairDesign& design) {
  const GearPairProblem& s = design.settled;
  return {*s.teeth[0],         *s.teeth[1],         *s.module,
          *s.profile_shift[0], *s.profile_shift[1], *s.centre_distance};
}

/// The centre distance with `backlash`, by halving: backlash grows with it.
double distance_with(Textbook pair, double backlash) {
  double low = pair.rb(pair.z1) + pair.rb(pair.z2), high = 2 * low;
  for (int i = 0; i < 50; ++i) {
    pair.a = 0.5 * (low + high);
    (pair.backlash() < backlash ? low : high) = pair.a;
  }
  return low;
}

constexpr GearObjective kAll[] = {GearObjective::balanced_sliding, GearObjective::contact_ratio,
                                  GearObjective::size};

// Li & Xu 2011, example 5-4, to more digits than the 0.765 that is printed.
TEST(GearPairSearch, ThatOfTheTextbookCannotDriveContinuously) {
  const auto result = solve(given_pair(20, 80, 5, 255), {});
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_EQ(result.designs.size(), 1u);
  const auto& metrics = result.designs[0].metrics;
  EXPECT_NEAR(quantity(metrics, "contact_ratio"), 0.7650371785946412, 1e-12);
  EXPECT_NEAR(quantity(metrics, "working_pressure_angle_deg"), 22.88794225358765, 1e-11);
  EXPECT_NEAR(quantity(metrics, "backlash"), 3.9750554756351124, 1e-10);
  EXPECT_NEAR(quantity(metrics, "continuous_centre_distance_max"), 253.67123369285025, 1e-9);
  EXPECT_NEAR(quantity(metrics, "pinion.tip_clearance"), 6.25, 1e-12);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("cannot drive continuously: its contact ratio is 0.765037"),
            std::string::npos);
  EXPECT_NE(result.notes[0].find("253.671234"), std::string::npos);
}

TEST(GearPairSearch, WithoutACentreDistanceHasTheBacklashAskedFor) {
  GearPairProblem problem = given_pair(20, 80, 5, 0);
  problem.centre_distance.reset();
  EXPECT_NEAR(quantity(solve(problem, {}).designs[0].metrics, "centre_distance"), 250, 1e-12);
  problem.profile_shift = {0.3, 0.4};
  problem.backlash = 0.2;
  const auto pair = textbook(solve(problem, {}).designs[0]);
  EXPECT_NEAR(pair.backlash(), 0.2, 1e-10);
}

TEST(GearPairSearch, WhoseTeethOverlapIsRefused) {
  const auto result = solve(given_pair(20, 80, 5, 249), {});
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_NE(result.notes.at(0).find("overlap"), std::string::npos);
  const auto closer = solve(given_pair(20, 80, 5, 200), {});  // base circles of 234.9 together
  EXPECT_EQ(closer.status, Status::infeasible);
  EXPECT_NE(closer.notes.at(0).find("base circles overlap"), std::string::npos);
}

TEST(GearPairSearch, SlidesAlikeAtBothFeetWhereTheCentreDistanceIsGiven) {
  GearPairProblem problem = spur_problem(GearObjective::balanced_sliding);
  problem.teeth = {14, 43};
  problem.module = 3;
  problem.centre_distance = 87;
  problem.backlash = 0.1;
  const auto result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const Textbook found = textbook(result.designs[0]);
  EXPECT_NEAR(found.sliding1(), found.sliding2(), 1e-9);
  EXPECT_NEAR(found.backlash(), 0.1, 1e-10);
  EXPECT_NEAR(quantity(result.designs[0].metrics, "sliding_max"), found.sliding(), 1e-9);
  EXPECT_NEAR(quantity(result.designs[0].metrics, "contact_ratio"), found.contact_ratio(), 1e-12);
  EXPECT_TRUE(found.is_sound(problem.constraints));
}

/// Every pair of the given teeth and module in a grid of shifts, if it is sound.
template <class Visit>
void visit_grid(const GearPairProblem& problem, int z1, int z2, double m, const Visit& visit) {
  constexpr double kStep = 0.03;
  const auto& [low, high] = problem.profile_shift_bounds;
  const double backlash = problem.backlash.value_or(0);
  for (double x1 = low; x1 <= high + 1e-9; x1 += kStep) {
    Textbook pair{z1, z2, m, x1, 0, 0};
    if (problem.centre_distance) {
      pair.a = *problem.centre_distance;
      // Backlash falls by the same for each shift: two values determine the one that is requested.
      const double none = pair.backlash();
      pair.x2 = 1;
      pair.x2 = (none - backlash) / (none - pair.backlash());
      if (pair.x2 < low || pair.x2 > high) continue;
      if (pair.is_sound(problem.constraints)) visit(pair);
      continue;
    }
    for (pair.x2 = low; pair.x2 <= high + 1e-9; pair.x2 += kStep) {
      pair.a = distance_with(pair, backlash);
      if (pair.is_sound(problem.constraints)) visit(pair);
    }
  }
}

TEST(GearPairSearch, NoPairOfAGridIsBetterWithShiftsAndDistanceFree) {
  std::vector<double> best;
  GearPairProblem problem = spur_problem(GearObjective::size);
  problem.teeth = {13, 29};
  problem.module = 2;
  problem.backlash = 0.05;
  for (const GearObjective objective : kAll) {
    problem.objective = objective;
    const auto result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    const Textbook found = textbook(result.designs[0]);
    EXPECT_TRUE(found.is_sound(problem.constraints));
    EXPECT_NEAR(found.backlash(), 0.05, 1e-9);
    best.push_back(found.objective(objective));
  }
  int count = 0;
  visit_grid(problem, 13, 29, 2, [&](const Textbook& pair) {
    ++count;
    for (std::size_t i = 0; i < best.size(); ++i) {
      EXPECT_GE(pair.objective(kAll[i]), best[i] - 1e-6) << pair.x1 << ' ' << pair.x2;
    }
  });
  EXPECT_GT(count, 200);
}

// With the least distance the wheel's tips reach just to where the pinion's flank begins, on its
// base circle.
TEST(GearPairSearch, TheSmallestPairIsToldOfAsSound) {
  GearPairProblem problem = spur_problem(GearObjective::size);
  problem.teeth = {12, 31};
  problem.module = 2;
  problem.profile_shift_bounds = {-0.6, 1.2};
  const auto result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.notes,
            std::vector<std::string>{"The specific sliding of the pinion is infinite: the path of "
                                     "contact reaches its base circle."});
  const Textbook found = textbook(result.designs[0]);
  EXPECT_TRUE(found.is_sound(problem.constraints));
  EXPECT_NEAR(found.foot1() / problem.module.value(), 0, 1e-3);
}

TEST(GearPairSearch, NoPairOfAGridIsBetterWithTeethAndModuleFree) {
  for (const GearObjective objective : {kAll[0], kAll[1]}) {
    GearPairProblem problem = spur_problem(objective);
    problem.teeth_bounds = {{{12, 20}, {26, 40}}};
    problem.modules = {2, 2.5};
    problem.centre_distance = 56;
    problem.ratio = 2.1;
    problem.ratio_tolerance = 0.1;
    const auto result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    const Textbook found = textbook(result.designs[0]);
    EXPECT_TRUE(found.is_sound(problem.constraints));
    EXPECT_NEAR(found.backlash(), 0, 1e-10);
    int count = 0, outside = 0;
    for (const double m : problem.modules) {
      for (int z1 = 12; z1 <= 20; ++z1) {
        for (int z2 = 26; z2 <= 40; ++z2) {
          if (std::abs(double(z2) / z1 / 2.1 - 1) > 0.1) {
            ++outside;
            continue;
          }
          visit_grid(problem, z1, z2, m, [&](const Textbook& pair) {
            ++count;
            EXPECT_GE(pair.objective(objective), found.objective(objective) - 1e-9);
          });
        }
      }
    }
    EXPECT_GT(count, 100);
    EXPECT_EQ(quantity(result.quantities, "combinations"), 2 * 9 * 15);
    EXPECT_EQ(quantity(result.quantities, "refused_by_ratio"), outside);
  }
}

TEST(GearPairSearch, DesignsAreTheSameWithAnyNumberOfThreads) {
  GearPairProblem problem = spur_problem(GearObjective::balanced_sliding);
  problem.teeth_bounds = {{{14, 16}, {30, 33}}};
  problem.modules = {2};
  problem.solve.designs = 4;
  const auto alone = solve(problem, {.threads = 1}), together = solve(problem, {.threads = 3});
  ASSERT_EQ(alone.designs.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(alone.designs[i].settled.teeth, together.designs[i].settled.teeth);
    EXPECT_EQ(alone.designs[i].settled.profile_shift, together.designs[i].settled.profile_shift);
    EXPECT_EQ(alone.designs[i].settled.centre_distance,
              together.designs[i].settled.centre_distance);
  }
}

TEST(GearPairSearch, HuntingTeethHaveNoCommonDivisor) {
  GearPairProblem problem = spur_problem(GearObjective::contact_ratio);
  problem.teeth_bounds = {{{18, 20}, {36, 41}}};
  problem.modules = {2};
  problem.constraints.hunting = true;
  problem.solve.designs = 100;
  const auto result = solve(problem, {});
  ASSERT_GT(result.designs.size(), 4u);
  for (const auto& design : result.designs) {
    EXPECT_EQ(std::gcd(*design.settled.teeth[0], *design.settled.teeth[1]), 1);
  }
}

TEST(GearPairSearch, OfImpossibleLimitsTellsWhichIsMissed) {
  GearPairProblem problem = spur_problem(GearObjective::balanced_sliding);
  problem.teeth = {14, 43};
  problem.module = 3;
  problem.centre_distance = 87;
  problem.constraints.sliding_max = 0.1;
  const auto result = solve(problem, {});
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_EQ(result.designs.size(), 1u);
  EXPECT_FALSE(all_satisfied(result.designs[0].constraints));
  problem = spur_problem(GearObjective::balanced_sliding);
  problem.teeth_bounds = {{{20, 22}, {30, 33}}};
  problem.modules = {2};
  problem.ratio = 3;
  const auto far = solve(problem, {});
  EXPECT_EQ(far.status, Status::infeasible);
  ASSERT_EQ(far.designs.size(), 1u);
  EXPECT_EQ(*far.designs[0].settled.teeth[0], 20);  // 33/20 is the nearest ratio
  EXPECT_EQ(*far.designs[0].settled.teeth[1], 33);
}

TEST(GearPairSearch, StopsWhereItIsInterrupted) {
  GearPairProblem problem = spur_problem(GearObjective::balanced_sliding);
  problem.teeth_bounds = {{{14, 40}, {30, 80}}};
  problem.modules = {2};
  const std::atomic<bool> stop{true};
  const auto result = solve(problem, {.interrupted = &stop});
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_EQ(result.designs.size(), 1u);  // what was found until then
}

TEST(GearPairSearch, HelicalShiftsAreThoseOfTheTransverseSection) {
  GearPairProblem problem = spur_problem(GearObjective::contact_ratio);
  problem.gearing = Gearing::helical;
  problem.helix = 18 * kPi / 180;
  problem.face_width = 28;
  problem.teeth = {21, 53};
  problem.module = 2.5;
  problem.centre_distance = 98;
  const auto result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const auto& settled = result.designs[0].settled;
  // inv α_t′ = inv α_t + 2 (x₁ + x₂) tan α_n/(z₁ + z₂), with shifts of the normal section.
  const double at = std::atan(std::tan(kAlpha) / std::cos(problem.helix));
  const double a = 0.5 * 2.5 * (21 + 53) / std::cos(problem.helix);
  const double working = std::acos(a * std::cos(at) / 98);
  const double sum = (inv(working) - inv(at)) * (21 + 53) / (2 * std::tan(kAlpha));
  EXPECT_NEAR(*settled.profile_shift[0] + *settled.profile_shift[1], sum, 1e-10);
  const double overlap = 28 * std::sin(problem.helix) / (kPi * 2.5);
  EXPECT_NEAR(quantity(result.designs[0].metrics, "overlap_ratio"), overlap, 1e-12);
}

}  // namespace
}  // namespace cognate::problems::gear_pair_search_test
