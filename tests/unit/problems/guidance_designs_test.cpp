// Body guidance as a problem: planted linkages come back, every design passes through its poses by
// the kernel's four-bar, degenerate poses are named.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/search.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems::guidance_designs_test {
namespace {

using synthesis::DyadKind;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

MotionProblem problem(std::vector<synthesis::Pose> poses) {
  MotionProblem made;
  made.poses = std::move(poses);
  made.dyads = {DyadKind::rr, DyadKind::pr, DyadKind::rp};
  return made;
}

Result solved(const MotionProblem& problem) {
  return solve(problem, problems::Run{});
}

bool mentions(const Result& result, const std::string& words) {
  return std::ranges::any_of(
      result.notes, [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

/// A crank-rocker with poses of its coupler at rising crank angles.
struct Planted {
  FourBar linkage;
  std::vector<synthesis::Pose> poses;
};

Planted planted(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> part(0, 1);
  Planted made;
  do {
    made.linkage = {{part(random), part(random)},
                    {3 + part(random), part(random)},
                    0.4 + part(random),
                    2 + 2 * part(random),
                    2 + 2 * part(random),
                    Assembly::open,
                    Vec2d{2 * part(random), 2 * part(random) - 1}};
  } while (!crank_rotates(lengths(made.linkage)));
  const double body_angle = 6 * part(random);
  const Motion motion(made.linkage);
  for (int k = 0; k < count; ++k) {
    const auto at = motion.at((k + 0.2 + 0.6 * part(random)) * kTurn / count);
    const Vec2d coupler = at->c - at->b;
    made.poses.push_back(
        {at->coupler_point.value(), std::atan2(coupler.y, coupler.x) + body_angle});
  }
  return made;
}

bool is_planted(const Design& design, const FourBar& planted, double tolerance) {
  if (!design.mechanism.four_bar()) return false;
  const FourBar& found = four_bar(design);
  const auto same = [&](const Vec2d& a, const Vec2d& d, double crank, double rocker) {
    return norm(found.pivot_a - a) + norm(found.pivot_d - d) <= tolerance &&
           std::abs(found.crank - crank) + std::abs(found.rocker - rocker) <= tolerance;
  };
  return same(planted.pivot_a, planted.pivot_d, planted.crank, planted.rocker) ||
         same(planted.pivot_d, planted.pivot_a, planted.rocker, planted.crank);
}

// The coupler point of the kernel's four-bar at the crank angles reported, not the chain by which
// the design was judged.
void expect_on_poses(const Design& design, const MotionProblem& problem) {
  if (!design.mechanism.four_bar() || !design.metrics.defects.empty()) return;
  const Motion motion(four_bar(design));
  const double size =
      std::max({four_bar(design).crank, four_bar(design).coupler, four_bar(design).rocker,
                lengths(four_bar(design)).frame, norm(*four_bar(design).coupler_point)});
  const double sine = std::sin(design.metrics.transmission_acute_min);
  const double tolerance = 100 * kEpsilon * size * *design.metrics.condition / sine;
  for (std::size_t i = 0; i < problem.poses.size(); ++i) {
    const auto at = motion.at(design.crank_angles[i]);
    ASSERT_TRUE(at);
    EXPECT_LE(norm(*at->coupler_point - problem.poses[i].at), tolerance);
  }
  EXPECT_LE(design.error.max, tolerance);
}

TEST(MotionGenerationTest, FivePosesGiveThePlantedLinkageBack) {
  std::mt19937 random(5);
  int recovered = 0;
  constexpr int kTrials = 300;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Planted plant = planted(random, 5);
    const MotionProblem asked = problem(plant.poses);
    const Result result = solved(asked);
    ASSERT_LE(result.designs.size(), 6U);
    double tolerance = 1e-9;
    for (const Design& design : result.designs) {
      expect_on_poses(design, asked);
      tolerance = std::max(tolerance, 1e4 * kEpsilon * *design.metrics.condition);
    }
    recovered += std::ranges::any_of(result.designs, [&](const Design& design) {
      return is_planted(design, plant.linkage, tolerance);
    });
  }
  EXPECT_EQ(recovered, kTrials);
}

TEST(MotionGenerationTest, ThreePosesByEitherPivot) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Planted plant = planted(random, 3);
    MotionProblem asked = problem(plant.poses);
    asked.fixed_pivots = {plant.linkage.pivot_a, plant.linkage.pivot_d};
    const Result by_fixed = solved(asked);
    ASSERT_EQ(by_fixed.designs.size(), 1U);
    const double tolerance = 1e4 * kEpsilon * *by_fixed.designs[0].metrics.condition + 1e-9;
    EXPECT_TRUE(is_planted(by_fixed.designs[0], plant.linkage, tolerance)) << trial;
    expect_on_poses(by_fixed.designs[0], asked);
    EXPECT_EQ(by_fixed.designs[0].origin, "exact:three-poses");
  }
}

TEST(MotionGenerationTest, FourPosesAreReachedByTheBestOfTheCurve) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 5; ++trial) {
    const Planted plant = planted(random, 4);
    MotionProblem asked = problem(plant.poses);
    asked.dyads = {DyadKind::rr};
    const Result result = solved(asked);
    ASSERT_FALSE(result.designs.empty());
    for (const Design& design : result.designs) expect_on_poses(design, asked);
    // The planted linkage is on the curve and has no defect, so what is found has none either and
    // transmits no worse.
    EXPECT_EQ(result.status, Status::solved);
    const double best = result.designs[0].metrics.transmission_acute_min;
    EXPECT_GT(best, transmission_angles(lengths(plant.linkage)).acute_min - 0.2);
    ASSERT_EQ(result.loci.size(), 2U);
    EXPECT_EQ(result.loci[0].name, "centre-point curve");
    EXPECT_FALSE(result.loci[0].branches.empty());
    EXPECT_FALSE(result.families.empty());
  }
}

TEST(MotionGenerationTest, FourPosesAreTheSameEveryTime) {
  std::mt19937 random(9);
  const MotionProblem asked = problem(planted(random, 4).poses);
  const Result one = solved(asked), two = solved(asked);
  ASSERT_EQ(one.designs.size(), two.designs.size());
  for (std::size_t i = 0; i < one.designs.size(); ++i) {
    EXPECT_EQ(one.designs[i].crank_angles, two.designs[i].crank_angles);
  }
}

TEST(MotionGenerationTest, ScaleAndPlaceChangeNothing) {
  std::mt19937 random(6);
  const Planted plant = planted(random, 5);
  const auto count = solved(problem(plant.poses)).designs.size();
  for (const double scale : {1e-9, 1e9}) {
    auto poses = plant.poses;
    for (auto& pose : poses) pose.at = scale * (pose.at + Vec2d{100, -50});
    const Result result = solved(problem(poses));
    ASSERT_EQ(result.designs.size(), count);
    FourBar moved = plant.linkage;
    moved.pivot_a = scale * (moved.pivot_a + Vec2d{100, -50});
    moved.pivot_d = scale * (moved.pivot_d + Vec2d{100, -50});
    moved.crank *= scale;
    moved.rocker *= scale;
    EXPECT_TRUE(std::ranges::any_of(result.designs, [&](const Design& design) {
      return is_planted(design, moved, 1e-8 * scale);
    }));
  }
}

TEST(MotionGenerationTest, CoincidentPosesAreNamedAndLeftOut) {
  std::mt19937 random(8);
  Planted plant = planted(random, 4);
  plant.poses.push_back(plant.poses[1]);
  const Result result = solved(problem(plant.poses));
  EXPECT_TRUE(mentions(result, "Pose 5 is pose 2 again"));
  EXPECT_FALSE(result.designs.empty());

  const Result one = solved(problem({{{1, 2}, 0.5}, {{1, 2}, 0.5}}));
  EXPECT_EQ(one.status, Status::no_solution);
  EXPECT_TRUE(mentions(one, "one pose only"));
}

TEST(MotionGenerationTest, TranslationIsAParallelogramOrASlide) {
  const Result circle = solved(problem({{{0, 0}, 0},
                                        {{1, 1}, 0},
                                        {{2, 0}, 0},
                                        {{1 - std::sqrt(0.5), std::sqrt(0.5)}, 0},
                                        {{1 + std::sqrt(0.5), std::sqrt(0.5)}, 0}}));
  EXPECT_TRUE(mentions(circle, "turned"));
  ASSERT_FALSE(circle.designs.empty());
  EXPECT_NEAR(four_bar(circle.designs[0]).crank, four_bar(circle.designs[0]).rocker, 1e-12);

  MotionProblem line = problem({{{0, 0}, 0}, {{1, 0}, 0}, {{3, 0}, 0}});
  line.moving_pivots = {{0, 1}, {2, 0}};
  const Result straight = solved(line);
  EXPECT_TRUE(straight.designs.empty());
  EXPECT_TRUE(mentions(straight, "slide in one direction"));
}

/// The dimensions of four-bars by the kernel at the crank angles reported.
void expect_sound_on_poses(const Result& result, const MotionProblem& asked) {
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_FALSE(result.designs.empty());
  for (const Design& design : result.designs) {
    EXPECT_TRUE(all_satisfied(design.constraints));
    EXPECT_LE(design.error.max, 1e-9);
    if (!design.metrics.change_point) expect_on_poses(design, asked);
  }
}

TEST(MotionGenerationTest, PivotAtThePoleLeavesItsPartnerFree) {
  MotionProblem asked = problem({{{1, 0}, 0}, {{0, 1}, kRightAngle}});  // a turn about the origin
  asked.moving_pivots = {{-1, 0}, {1, 1}};  // the first is at the origin
  const Result moving = solved(asked);
  expect_sound_on_poses(moving, asked);
  EXPECT_TRUE(mentions(moving, "Moving pivot [-1, 0]"));

  asked.moving_pivots.clear();
  asked.fixed_pivots = {{0, 0}, {3, 0}};
  const Result fixed = solved(asked);
  expect_sound_on_poses(fixed, asked);
  EXPECT_TRUE(mentions(fixed, "any moving pivot will do"));

  asked.crank = 0.75;
  const Result of_length = solved(asked);
  expect_sound_on_poses(of_length, asked);
  const FourBar& found = four_bar(of_length.designs.at(0));  // either may be driven
  EXPECT_NEAR(std::min(std::abs(found.crank - 0.75), std::abs(found.rocker - 0.75)), 0, 1e-12);
}

// Poses on a circle, the body not turned: the links of any parallelogram, but not through its dead
// points.
void expect_parallelograms(const Result& result) {
  ASSERT_FALSE(result.designs.empty());
  for (const Design& design : result.designs) {
    const auto [crank, coupler, rocker, frame] = lengths(four_bar(design));
    EXPECT_NEAR(crank, rocker, 1e-9);
    EXPECT_NEAR(coupler, frame, 1e-9);
    EXPECT_LT(std::max(crank, coupler) / std::min(crank, coupler), 5);
    EXPECT_LE(design.error.max, 1e-9);
  }
}

TEST(MotionGenerationTest, TranslationsOnACircleHaveSoundParallelograms) {
  const std::vector<std::vector<synthesis::Pose>> cases{
      {{{0, 0}, 0}, {{1, 1}, 0}, {{3, 1}, 0}},
      {{{0, 0}, 0}, {{1, 1}, 0}, {{3, 1}, 0}, {{4, 0}, 0}},
      {{{1, 0}, 2}, {{0.6, 0.8}, 2}, {{0, 1}, 2}, {{-0.8, 0.6}, 2}, {{-0.96, 0.28}, 2}}};
  for (const auto& poses : cases) {
    const MotionProblem asked = problem(poses);
    const Result result = solved(asked);
    expect_sound_on_poses(result, asked);
    expect_parallelograms(result);
  }
}

// Round more than half of the circle the crank crosses the line of the frame.
TEST(MotionGenerationTest, TranslationsRoundACircleCrossDeadPoints) {
  const std::vector<std::vector<synthesis::Pose>> cases{
      {{{1, 0}, 0}, {{0, 1}, 0}, {{-1, 0}, 0}, {{0.6, -0.8}, 0}},
      {{{1, 1}, 0}, {{-1, 1}, 0}, {{-1, -1}, 0}, {{1, -1}, 0}},
      {{{1, 0}, 2}, {{0.6, 0.8}, 2}, {{0, 1}, 2}, {{-0.8, 0.6}, 2}, {{0, -1}, 2}}};
  for (const auto& poses : cases) {
    const Result result = solved(problem(poses));
    EXPECT_EQ(result.status, Status::infeasible);
    EXPECT_EQ(result.notes.size(), 1U);
    EXPECT_TRUE(mentions(result, "dead points"));
    expect_parallelograms(result);
  }
}

// No pair among many drawn at random from the families is better than the best that is found.
TEST(MotionGenerationTest, TheBestPairIsNoWorseThanThousandsDrawn) {
  MotionProblem asked = problem({{{0, 0}, 0}, {{2, 1}, 20 * kDegree}, {{4, 1}, 50 * kDegree}});
  asked.dyads = {DyadKind::rr};
  problems::Run run;
  const DyadPairChoices options = dyads_of_few_poses(asked);
  const auto best = ranked_pairs(asked, options, 3, Deadline(run)).pairs.at(0).judgement;
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  int judged = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto draw = [&](const DyadChoices& options) {
      return options.dyad_at({place(random), place(random), 0, double(DyadKind::rr)});
    };
    const auto first = draw(options.first), second = draw(options.second.value_or(options.first));
    if (!first || !second) continue;
    const auto found = judge(asked, {*first, *second});
    judged += found.has_value();
    EXPECT_FALSE(found && found->is_better_than(best))
        << i << ' ' << found->merit << ' ' << best.merit;
  }
  EXPECT_GT(judged, 10000);
}

TEST(MotionGenerationTest, LinksAreOfOneOrderOfLength) {
  MotionProblem asked = problem({{{0, 0}, 0}, {{2, 1}, 20 * kDegree}, {{4, 1}, 50 * kDegree}});
  asked.constraints.required_class = RequiredClass::double_crank;
  for (const Design& design : solved(asked).designs) {
    const auto [crank, coupler, rocker, frame] = lengths(four_bar(design));
    const auto [shortest, longest] = std::minmax({crank, coupler, rocker, frame});
    EXPECT_LT(longest / shortest, 100);
  }
}

/// The best of dyads of `kind` alone through the first `count` of three poses.
Design best_of_slides(DyadKind kind, std::ptrdiff_t count) {
  const std::vector<synthesis::Pose> poses{{{1, 1}, 0}, {{-1, 1}, -kRightAngle}, {{-1.2, -1}, -3}};
  MotionProblem asked = problem({poses.begin(), poses.begin() + count});
  asked.dyads = {kind};
  asked.solve.designs = 1;
  const Result result = solved(asked);
  expect_sound_on_poses(result, asked);
  return result.designs.empty() ? Design{} : result.designs[0];
}

// The link of an elliptic trammel passes through any three poses.
TEST(MotionGenerationTest, SlidersAloneGuideThroughTwoAndThreePoses) {
  for (const std::ptrdiff_t count : {2, 3}) {
    const Design best = best_of_slides(DyadKind::pr, count);
    const auto* trammel = std::get_if<EllipticTrammel>(&best.mechanism.description);
    ASSERT_TRUE(trammel) << count;
    EXPECT_GT(trammel->length, 0.1) << count;
  }
}

// And so does the disc of an Oldham coupling, as the frame seen from the trammel's link.
TEST(MotionGenerationTest, BlocksAloneGuideThroughTwoAndThreePoses) {
  for (const std::ptrdiff_t count : {2, 3}) {
    EXPECT_EQ(best_of_slides(DyadKind::rp, count).mechanism.type(), MechanismType::oldham_coupling);
  }
}

// A turn about the body's origin has no extent by which designs could be distinguished.
TEST(MotionGenerationTest, DesignsOfATurnDiffer) {
  MotionProblem asked = problem({{{0, 0}, 0}, {{0, 0}, 1}});
  asked.moving_pivots = {{1, 0}, {0, 1}};
  asked.dyads = {DyadKind::rr};
  const Result result = solved(asked);
  ASSERT_GE(result.designs.size(), 2U);
  for (std::size_t i = 1; i < result.designs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const FourBar &one = four_bar(result.designs[i]), &other = four_bar(result.designs[j]);
      EXPECT_GT(norm(one.pivot_a - other.pivot_a) + norm(one.pivot_d - other.pivot_d), 0.02);
    }
  }
}

TEST(MotionGenerationTest, DegeneratePosesAreNamedOnce) {
  const Result turns = solved(problem({{{1, 0}, 0}, {{0, 1}, kRightAngle}, {{-1, 0}, kPi}}));
  EXPECT_EQ(turns.status, Status::no_solution);
  EXPECT_TRUE(mentions(turns, "turns about one point"));
  for (const std::size_t count : {3U, 4U, 5U}) {
    MotionProblem asked = problem({});
    for (std::size_t k = 0; k < count; ++k) asked.poses.push_back({{double(k * k), 0}, 1});
    const Result line = solved(asked);
    EXPECT_EQ(line.status, Status::no_solution);
    ASSERT_EQ(line.notes.size(), 1U) << count;
    EXPECT_TRUE(mentions(line, "a slide on the frame guides it")) << count;
  }
}

TEST(MotionGenerationTest, LinkTooShortIsNamed) {
  MotionProblem asked = problem({{{0, 0}, 0}, {{10, 0}, 0.5}});
  asked.moving_pivots = {{0, 0}, {1, 1}};
  asked.crank = 1;
  const Result result = solved(asked);
  EXPECT_EQ(result.status, Status::no_solution);
  EXPECT_TRUE(mentions(result, "Moving pivot [0, 0]"));
}

TEST(MotionGenerationTest, NoRealDyadIsSaid) {
  // Random poses have none now and then.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  int none = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<synthesis::Pose> poses;
    for (int k = 0; k < 5; ++k) poses.push_back({{unit(random), unit(random)}, 3 * unit(random)});
    const Result result = solved(problem(poses));
    if (!result.designs.empty()) continue;
    ++none;
    EXPECT_EQ(result.status, Status::no_solution);
    EXPECT_TRUE(mentions(result, "No real dyad") || mentions(result, "makes no mechanism"));
  }
  EXPECT_GT(none, 10);
}

TEST(MotionGenerationTest, KindsOfDyadsAreKeptTo) {
  MotionProblem asked = problem({{{0, 0}, 0}, {{2, 1}, 0.4}, {{4, 1}, 0.9}});
  asked.dyads = {DyadKind::pr};
  asked.moving_pivots = {{0, 0}, {1, 1}};
  const Result result = solved(asked);
  EXPECT_TRUE(result.designs.empty());
  EXPECT_TRUE(mentions(result, "RR is left out"));
}

// A slider-crank and an oscillating block serve these poses best, with pivots outside the boxes.
TEST(MotionGenerationTest, BoundsOfPivotsHoldForEveryMechanism) {
  int tested = 0;
  MotionProblem asked = problem({{{-1, -1}, 90 * kDegree},
                                 {{-1.4204, 0.3232}, 55.0347 * kDegree},
                                 {{-0.0292, 1.9547}, 1.712 * kDegree},
                                 {{1.0621, 0.3645}, 55.0346 * kDegree}});
  asked.bounds.pivot_a = Box{{5, 5}, {6, 6}};
  asked.bounds.pivot_d = Box{{5, 5}, {6, 6}};
  for (const Design& design : solved(asked).designs) {
    for (const NamedPoint& point : design.mechanism.points) {
      if (point.at.body != 0 || (point.name != "A" && point.name != "D")) continue;
      ++tested;
      const Vec2d& at = point.at.at;
      const bool inside = at.x >= 5 && at.y >= 5 && at.x <= 6 && at.y <= 6;
      EXPECT_TRUE(inside || !all_satisfied(design.constraints)) << at.x << ' ' << at.y;
    }
  }
  EXPECT_GE(tested, 5);
}

TEST(MotionGenerationTest, StopsInTime) {
  std::mt19937 random(1);
  problems::Run run;
  run.time_limit = 1e-9;
  const Result result = solve(problem(planted(random, 4).poses), run);
  EXPECT_EQ(result.status, Status::time_limit);
  EXPECT_TRUE(result.notes.empty()) << result.notes.front();
}

}  // namespace
}  // namespace cognate::problems::guidance_designs_test
