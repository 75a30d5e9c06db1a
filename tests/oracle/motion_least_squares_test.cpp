/// Motion generation by least squares against published and planted designs, each evaluated by the
/// textbook's angles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "synthesis/fit/dyad_fit.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::motion_least_squares_test {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;

/// Seeds per problem, unless the environment sets fewer (slow builds).
int seeds(int most) {
  const char* text = std::getenv("COGNATE_TEST_SEEDS");
  return text ? std::clamp(std::atoi(text), 1, most) : most;
}

double quantity(const Design& design, const std::string& name) {
  for (const Quantity& quantity : design.metrics.quantities) {
    if (quantity.name == name) return std::get<double>(quantity.value);
  }
  ADD_FAILURE() << "no " << name;
  return 0;
}

/// Where a four-bar takes the axes of its coupler point, turned by `in_link`: law of cosines at B.
synthesis::Pose textbook_pose(const FourBar& l, double crank_angle, double in_link) {
  const double bx = l.pivot_a.x + l.crank * std::cos(crank_angle);
  const double by = l.pivot_a.y + l.crank * std::sin(crank_angle);
  const double dx = l.pivot_d.x - bx, dy = l.pivot_d.y - by, d = std::hypot(dx, dy);
  const double at_b =
      std::acos((l.coupler * l.coupler + d * d - l.rocker * l.rocker) / (2 * l.coupler * d));
  const double phi = std::atan2(dy, dx) + (l.assembly == Assembly::open ? at_b : -at_b);
  const double u = l.coupler_point->x, v = l.coupler_point->y;
  return {{bx + u * std::cos(phi) - v * std::sin(phi), by + u * std::sin(phi) + v * std::cos(phi)},
          phi + in_link};
}

double textbook_error(const MotionProblem& problem, const Design& design) {
  const double in_link = quantity(design, "body_angle_in_link_deg") * kPi / 180;
  double sum = 0;
  for (std::size_t j = 0; j < problem.poses.size(); ++j) {
    const auto pose = textbook_pose(four_bar(design), design.crank_angles[j], in_link);
    const double turn = std::remainder(pose.angle - problem.poses[j].angle, kTurn);
    sum += squared_norm(pose.at - problem.poses[j].at) +
           problem.angle_weight * problem.angle_weight * turn * turn;
  }
  return sum;
}

MotionProblem eleven_poses() {
  const auto problem =
      read_task(std::filesystem::path(kLibraryFolder) / "motion/eleven-poses.toml");
  return std::get<MotionProblem>(problem.value());
}

TEST(McCarthyChallenge, HasTheTwoLinksFoundByThreeThousandStarts) {
  const MotionProblem problem = eleven_poses();
  const struct {
    Vec2d fixed, moving;
    double length, misfit;
  } known[] = {{{2.21415807, 1.61702549}, {1.43521912, -1.94138391}, 1.73220418, 1.762958e-4},
               {{0.78536611, 0.38333603}, {1.56441539, -0.05836141}, 1.73188188, 1.786893e-4}};
  for (const auto& link : known) {
    const Vec2d off{0.02, -0.03};
    const auto start = synthesis::rr_dyad(problem.poses, link.moving + off, link.fixed - off);
    const auto found = synthesis::nearest_link(start, problem.poses);
    ASSERT_TRUE(found);
    EXPECT_NEAR(synthesis::squared_misfit(*found, problem.poses), link.misfit, 1e-10);
    EXPECT_NEAR(norm(found->fixed - link.fixed), 0, 1e-6);
    EXPECT_NEAR(norm(found->in_body - link.moving), 0, 1e-6);
    EXPECT_NEAR(found->length, link.length, 1e-6);
  }
}

/// A four-bar and the poses through which it takes a body.
struct Planted {
  FourBar linkage;
  MotionProblem problem;
};

Planted planted(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> uniform(0, 1);
  for (;;) {
    FourBar linkage{{uniform(random), uniform(random)},
                    {2 + uniform(random), 2 * uniform(random)},
                    0.4 + 0.5 * uniform(random),
                    1.2 + 1.5 * uniform(random),
                    1.2 + 1.5 * uniform(random),
                    uniform(random) < 0.5 ? Assembly::open : Assembly::crossed,
                    Vec2d{3 * uniform(random) - 1, 3 * uniform(random) - 1.5}};
    const double in_link = 6 * uniform(random), from = 6 * uniform(random);
    const double sweep = 1 + 4 * uniform(random);
    Planted made{linkage, {}};
    made.problem.method = MotionMethod::least_squares;
    made.problem.dyads = {DyadKind::rr, DyadKind::pr, DyadKind::rp};
    made.problem.solve.designs = 1;
    bool closes = true;
    for (int k = 0; k < count; ++k) {
      const auto pose = textbook_pose(linkage, from + sweep * k / count, in_link);
      closes = closes && std::isfinite(pose.angle);
      made.problem.poses.push_back(pose);
    }
    if (!closes) continue;
    made.problem.angle_weight = natural_angle_weight(made.problem.poses);
    return made;
  }
}

TEST(MotionLeastSquares, PlantedFourBarsComeBack) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < seeds(5); ++trial) {
    const int count = 6 + 6 * trial;
    SCOPED_TRACE(::testing::Message() << "trial " << trial << ", " << count << " poses");
    const auto [linkage, problem] = planted(random, count);
    const Result result = solve(problem, {.seed = 1});
    ASSERT_EQ(result.status, Status::solved);
    const Design& design = result.designs.front();
    const double size = natural_angle_weight(problem.poses);
    EXPECT_LE(design.error.sum_of_squares, 1e-20 * size * size);
    EXPECT_LE(textbook_error(problem, design), 1e-20 * size * size);
    // Driven by either link it is the planted one.
    const FourBar& found = four_bar(design);
    const double forth =
        norm(found.pivot_a - linkage.pivot_a) + norm(found.pivot_d - linkage.pivot_d);
    const double back =
        norm(found.pivot_a - linkage.pivot_d) + norm(found.pivot_d - linkage.pivot_a);
    EXPECT_LE(std::min(forth, back), 1e-5);
  }
}

TEST(MotionLeastSquares, NoiseCostsNoMoreThanThePlantedLinkagesOwnError) {
  std::mt19937_64 random(21);
  std::normal_distribution<double> normal(0, 1);
  const auto [linkage, exact] = planted(random, 14);
  double last = 0;
  for (const double noise : {1e-6, 1e-4, 1e-3, 1e-2}) {
    MotionProblem problem = exact;
    problem.dyads = {DyadKind::rr};
    problem.constraints.no_order_defect = false;  // noise may turn neighbours round
    double own = 0;                               // of the planted linkage at its own crank angles
    for (synthesis::Pose& pose : problem.poses) {
      const Vec2d moved = noise * Vec2d{normal(random), normal(random)};
      const double turned = noise * normal(random);
      pose = {pose.at + moved, pose.angle + turned};
      own += squared_norm(moved) + problem.angle_weight * problem.angle_weight * turned * turned;
    }
    const Result result = solve(problem, {.seed = 3});
    ASSERT_FALSE(result.designs.empty());
    const double error = result.designs.front().error.sum_of_squares;
    EXPECT_LE(error, own);
    EXPECT_GE(error, 0.05 * own);  // 42 numbers, 24 of them fitted
    EXPECT_GT(error, last);
    EXPECT_NEAR(textbook_error(problem, result.designs.front()), error,
                1e-14 * std::sqrt(own) + 1e-12 * own);
    last = error;
  }
}

TEST(MotionLeastSquares, ScaledTurnedAndShiftedPosesGiveTheSameDesign) {
  const MotionProblem problem = eleven_poses();
  const double scale = 250, angle = 0.7;
  const Vec2d turn{std::cos(angle), std::sin(angle)}, shift{-3e3, 800};
  MotionProblem moved = problem;
  for (synthesis::Pose& pose : moved.poses) {
    pose = {shift + scale * (turn * pose.at), pose.angle + angle};
  }
  moved.angle_weight = scale * problem.angle_weight;
  const auto a = solve(problem, {.seed = 1}), b = solve(moved, {.seed = 1});
  ASSERT_FALSE(a.designs.empty());
  ASSERT_FALSE(b.designs.empty());
  const FourBar &first = four_bar(a.designs[0]), &second = four_bar(b.designs[0]);
  EXPECT_NEAR(b.designs[0].error.sum_of_squares / (scale * scale),
              a.designs[0].error.sum_of_squares, 1e-12);
  const Vec2d moved_a = shift + scale * (turn * first.pivot_a);
  const Vec2d moved_d = shift + scale * (turn * first.pivot_d);
  const double off = std::min(norm(second.pivot_a - moved_a) + norm(second.pivot_d - moved_d),
                              norm(second.pivot_a - moved_d) + norm(second.pivot_d - moved_a));
  EXPECT_LE(off, 1e-4 * scale);
}

TEST(MotionLeastSquares, KeepsWhatTheFileGives) {
  MotionProblem problem = eleven_poses();
  problem.fixed_pivots = {{2.2, 1.6}, {0.8, 0.4}};
  const Result result = solve(problem, {.seed = 1});
  ASSERT_EQ(result.status, Status::solved);
  const FourBar& found = four_bar(result.designs.front());
  const bool first = found.pivot_a == problem.fixed_pivots[0];  // either may drive
  EXPECT_EQ(found.pivot_a, problem.fixed_pivots[first ? 0 : 1]);
  EXPECT_EQ(found.pivot_d, problem.fixed_pivots[first ? 1 : 0]);
  // Worse than with the best pivots, better than with these and its other dimensions.
  EXPECT_GT(result.designs.front().error.sum_of_squares, 2.15377e-4);
  EXPECT_LT(result.designs.front().error.sum_of_squares, 1e-2);
  EXPECT_NEAR(textbook_error(problem, result.designs.front()),
              result.designs.front().error.sum_of_squares, 1e-13);

  problem.fixed_pivots.clear();
  problem.moving_pivots = {{1.4, -1.9}};
  problem.crank = 1.7;
  const Result other = solve(problem, {.seed = 1});
  ASSERT_EQ(other.status, Status::solved);
  EXPECT_EQ(four_bar(other.designs.front()).crank, 1.7);
}

TEST(MotionLeastSquares, KeepsToConstraints) {
  MotionProblem problem = eleven_poses();
  problem.constraints.required_class = RequiredClass::crank_rocker;
  problem.constraints.transmission_angle = Range{0.5, 2.6};
  problem.constraints.link_ratio_max = 8;
  problem.bounds.frame = Range{1, 6};
  problem.bounds.pivot_a = Box{{-3, -3}, {3, 3}};
  problem.moving_bounds[0] = Box{{-3, -3}, {3, 3}};
  const Result result = solve(problem, {.seed = 2});
  ASSERT_EQ(result.status, Status::solved);
  const Design& design = result.designs.front();
  for (const ConstraintCheck& check : design.constraints) {
    EXPECT_TRUE(check.satisfied) << check.name;
  }
  const auto links = lengths(four_bar(design));
  const double longest = std::max({links.coupler, links.rocker, links.frame});
  EXPECT_LE(links.crank + longest,
            (links.coupler + links.rocker + links.frame - longest) * (1 + 1e-12));
  EXPECT_LE(longest, 8 * links.crank * (1 + 1e-9));
  EXPECT_GT(design.error.sum_of_squares, 2.1537e-4);
}

TEST(MotionLeastSquares, SaysWhatCannotBeKept) {
  MotionProblem problem = eleven_poses();
  problem.dyads = {DyadKind::rr};
  problem.constraints.pivot_region = Box{{0, 0}, {0.5, 0.5}};
  problem.bounds.frame = Range{2, 3};  // longer than the region is wide
  const Result result = solve(problem, {.seed = 1});
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_FALSE(result.designs.empty());
  for (const Design& design : result.designs) {
    EXPECT_TRUE(std::ranges::any_of(design.constraints,
                                    [](const ConstraintCheck& check) { return !check.satisfied; }));
  }
  ASSERT_FALSE(result.notes.empty());
  for (const char* key : {"pivot_region = [[", "bounds.frame = ["}) {
    EXPECT_NE(result.notes.back().find(key), std::string::npos) << result.notes.back();
  }
}

TEST(MotionLeastSquares, OtherSolversFinishAtTheSameLinkage) {
  MotionProblem problem = eleven_poses();
  problem.solve.starts = 20;
  problem.solve.designs = 1;
  for (const auto& [choice, name] : {std::pair{synthesis::Solver::ceres, "ceres"},
                                     {synthesis::Solver::slsqp, "slsqp"},
                                     {synthesis::Solver::cobyla, "cobyla"}}) {
    problem.solve.solver = choice;
    const Result result = solve(problem, {.seed = 1});
    ASSERT_EQ(result.status, Status::solved) << name;
    EXPECT_NEAR(result.designs.front().error.sum_of_squares, 2.15377440765e-4, 1e-10) << name;
    EXPECT_TRUE(result.designs.front().origin.ends_with(std::string(" + ") + name));
  }
}

TEST(MotionLeastSquares, IsTheSameForAnyNumberOfThreads) {
  const MotionProblem problem = eleven_poses();
  const auto one = solve(problem, {.seed = 5, .threads = 1});
  const auto three = solve(problem, {.seed = 5, .threads = 3});
  ASSERT_EQ(one.designs.size(), three.designs.size());
  for (std::size_t i = 0; i < one.designs.size(); ++i) {
    EXPECT_EQ(one.designs[i].error.sum_of_squares, three.designs[i].error.sum_of_squares);
    EXPECT_EQ(one.designs[i].crank_angles, three.designs[i].crank_angles);
    EXPECT_EQ(one.designs[i].origin, three.designs[i].origin);
  }
}

TEST(MotionLeastSquares, StopsAtItsTimeLimit) {
  MotionProblem problem = eleven_poses();
  problem.solve.starts = 1000000;
  const Result result = solve(problem, {.time_limit = 0.2});
  EXPECT_EQ(result.status, Status::time_limit);
}

TEST(MotionLeastSquares, SaysThatAMotionIsSpecial) {
  MotionProblem turned, shifted, still, pinned;
  for (int k = 0; k < 7; ++k) {
    const double angle = 0.2 * k;
    turned.poses.push_back({{1 + 2 * std::cos(angle), 2 * std::sin(angle)}, angle});
    shifted.poses.push_back({{0.1 * k * k, 1.0 * k}, 0.5});
    still.poses.push_back({{1, 2}, 0.5});
    pinned.poses.push_back({{5, 3}, angle});
  }
  for (const auto& [problem, word] : {std::pair{turned, "turns about one point"},
                                      {pinned, "turns about one point"},
                                      {shifted, "no pose is turned"},
                                      {still, "All poses coincide"}}) {
    MotionProblem asked = problem;
    asked.method = MotionMethod::least_squares;
    asked.dyads = {DyadKind::rr};
    asked.solve.starts = 10;
    const Result result = solve(asked, {.seed = 1});
    ASSERT_FALSE(result.notes.empty()) << word;
    EXPECT_NE(result.notes.front().find(word), std::string::npos) << result.notes.front();
    for (const Design& design : result.designs) {
      EXPECT_TRUE(std::isfinite(design.error.sum_of_squares));
    }
  }
}

TEST(MotionLeastSquares, LongListsAreFittedAtEveryPose) {
  std::mt19937_64 random(8);
  const auto [linkage, problem] = planted(random, 300);
  const Result result = solve(problem, {.seed = 1});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.designs.front().crank_angles.size(), 300U);
  EXPECT_LE(textbook_error(problem, result.designs.front()), 1e-18);
}

/// A slider-crank's body comes back as a slider-crank.
TEST(MotionLeastSquares, APlantedSliderCrankComesBack) {
  const double crank = 0.7, rod = 2.1, offset = 0.3;
  MotionProblem problem;
  problem.method = MotionMethod::least_squares;
  problem.dyads = {DyadKind::rr, DyadKind::pr};
  problem.angle_weight = 1;
  problem.solve.designs = 1;
  for (int k = 0; k < 9; ++k) {
    const double angle = 0.4 + 0.35 * k;
    const Vec2d pin{crank * std::cos(angle), crank * std::sin(angle)};
    const double turn = std::asin((offset - pin.y) / rod);
    const Vec2d along{std::cos(turn), std::sin(turn)};
    problem.poses.push_back({pin + along * Vec2d{0.6, 0.4}, turn + 0.5});
  }
  const Result result = solve(problem, {.seed = 1});
  ASSERT_EQ(result.status, Status::solved);
  const Design& design = result.designs.front();
  EXPECT_EQ(design.mechanism.type(), MechanismType::slider_crank);
  EXPECT_LE(design.error.sum_of_squares, 1e-22);
}

}  // namespace
}  // namespace cognate::problems::motion_least_squares_test
