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

namespace cognate::problems {
namespace {

constexpr double kAlpha = kPi / 9;

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

GearPairProblem spur_problem(GearObjective objective) {
  GearPairProblem problem;
  problem.rack.pressure_angle = kAlpha;
  problem.objective = objective;
  problem.constraints.contact_ratio_min = 1.2;
  problem.constraints.tip_thickness_min = 0.25;
  problem.profile_shift_bounds = {-0.5, 1};
  return problem;
}

GearPairProblem given_pair(int z1, int z2, double module, double centre_distance) {
  GearPairProblem problem;
  problem.teeth = {z1, z2};
  problem.module = module;
  problem.profile_shift = {0, 0};
  problem.centre_distance = centre_distance;
  return problem;
}

double quantity(const std::vector<Quantity>& quantities, const std::string& name) {
  for (const Quantity& each : quantities) {
    if (each.name == name) return std::get<double>(each.value);
  }
  ADD_FAILURE() << "no fact " << name;
  return NAN;
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
      // Backlash falls by the same for each shift: two values tell the one that is requested.
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

// With the least distance the wheel's tips reach just to where the pinion's flank begins.
TEST(GearPairSearch, TheSmallestPairIsToldOfAsSound) {
  GearPairProblem problem = spur_problem(GearObjective::size);
  problem.teeth = {12, 31};
  problem.module = 2;
  problem.profile_shift_bounds = {-0.6, 1.2};
  const auto result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_TRUE(result.notes.empty()) << result.notes[0];
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
TEST(GearPairSearch, TellsTheDistancesAtWhichAPairDrivesContinuously) {
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

TEST(GearPairSearch, RefusesTeethWhoseBaseCirclesOverlap) {
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

TEST(GearPairSearch, TheNearestPairMissesNothingElseNeedlessly) {
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
TEST(GearPairSearch, ScaledCopiesAreSearchedOnce) {
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

TEST(GearPairSearch, OfManyCombinationsNoneThatIsSearchedAloneIsBetter) {
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

TEST(GearPairSearch, ARunThatIsCutSaysSoAndHasSeenSomeOfAllSizes) {
  GearPairProblem problem = spur_problem(GearObjective::balanced_sliding);
  problem.teeth_bounds = {{{12, 40}, {20, 110}}};
  problem.modules = {2};
  std::atomic<bool> stop{false};
  const auto progress = [&](double share, double) { stop = share > 0.02; };
  const auto cut = solve(problem, {.threads = 1, .interrupted = &stop, .progress = progress});
  EXPECT_EQ(cut.status, Status::interrupted);
  EXPECT_EQ(cut.designs.size(), 3u);
  EXPECT_TRUE(has_note(cut, " of 2639 combinations had been looked at"));
  EXPECT_LT(quantity(cut.quantities, "combinations_searched_coarsely"), 80);
  EXPECT_EQ(quantity(cut.quantities, "combinations_searched"), 0);
  EXPECT_GT(*cut.designs[0].settled.teeth[0], 30);  // those of many teeth slide least
}

TEST(GearPairSearch, HelicalTipsAndPlayAreMeasuredAcrossTheTeeth) {
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

// The wheel of a worm is, in its middle plane, the gear that kind = "gear" makes of its numbers.
TEST(GearPairSearch, AWormWheelIsJudgedAsTheGearThatItIs) {
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

TEST(GearPairSearch, NotesTellWhatIsAllowedAndWhatIsInfinite) {
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

TEST(GearPairSearch, BevelGearsWhoseConesAreNearlyFlatAreSound) {
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
}  // namespace cognate::problems
