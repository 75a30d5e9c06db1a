/// The exact smallest cam against general solvers, and what general solvers find alone.
#include <gtest/gtest.h>

#include "problems/cam/extremes.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::cam_search_test {
namespace {

using problems::CamProblem;
using synthesis::Solver;

double base_radius(const problems::CamResult& result) {
  return result.designs.at(0).cam.system.follower.dimensions.base_radius;
}

CamProblem random_translating(std::mt19937_64& random) {
  std::uniform_real_distribution<double> limit(20, 50), stroke(5, 40);
  CamProblem problem = translating_roller({}, {}, 1e-3);
  problem.motion = random_motion(random, stroke(random));
  problem.constraints.curvature_radius_min.reset();
  problem.constraints.pressure_angle_max_rise = limit(random) * kDegree;
  problem.constraints.pressure_angle_max_return = limit(random) * kDegree;
  if (random() % 3 == 0) problem.constraints.pressure_angle_max = 50 * kDegree;
  return problem;
}

CamProblem random_oscillating(std::mt19937_64& random) {
  std::uniform_real_distribution<double> limit(25, 55), swing(5, 40);
  CamProblem problem = oscillating_roller({}, {}, 50, 1e-3);
  problem.side = random() % 2 == 0 ? cam::ArmSide::trailing : cam::ArmSide::leading;
  problem.motion = random_motion(random, swing(random) * kDegree);
  problem.constraints.curvature_radius_min.reset();
  problem.constraints.pressure_angle_max_rise = limit(random) * kDegree;
  problem.constraints.pressure_angle_max_return = limit(random) * kDegree;
  return problem;
}

/// The exact answer is not larger than what a general solver finds, and not smaller than what it
/// keeps its limits with.
void compare(CamProblem problem, int index) {
  const auto exact = solve(problem, {.threads = 1});
  ASSERT_EQ(exact.designs.at(0).origin, "exact:half-planes") << index;
  ASSERT_TRUE(exact.designs.at(0).proof);
  EXPECT_TRUE(problems::all_satisfied(exact.designs[0].constraints)) << index;
  for (const auto solver : {synthesis::Solver::slsqp, synthesis::Solver::ipopt}) {
    problem.solve.solver = solver;
    problem.solve.starts = 2;
    const auto general = solve(problem, {.threads = 1});
    ASSERT_FALSE(general.designs.empty()) << index;
    EXPECT_TRUE(problems::all_satisfied(general.designs[0].constraints)) << index;
    EXPECT_NEAR(base_radius(general), base_radius(exact), 1e-7 * base_radius(exact)) << index;
  }
}

TEST(CamSearch, ExactAgreesWithGeneralSolversForTranslatingRollers) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 8; ++i) compare(random_translating(random), i);
}

TEST(CamSearch, ExactAgreesWithGeneralSolversForOscillatingRollers) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 8; ++i) compare(random_oscillating(random), i);
}

// The positions of the proof alone, put into the pressure angle's formula, give the base radius.
TEST(CamSearch, ProofHoldsInItsPositions) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 30; ++i) {
    const auto result = solve(random_translating(random), {.threads = 1});
    const auto& design = result.designs.at(0);
    ASSERT_FALSE(design.proof->positions.empty());
    for (const auto& position : design.proof->positions) {
      const auto m = design.cam.programme.at(position.angle);
      const double angle = value_of(cam::CamQuantity::pressure_angle, design.cam.system, m);
      EXPECT_NEAR(std::abs(angle) / kDegree, position.bound, 1e-9) << i;
    }
  }
}

// SLSQP goes on searching along a line for ever here: no roller so far off its axis can keep the
// limit, and the linear constraints of its steps contradict one another.
TEST(CamSearch, EndsWhereLimitsContradictBounds) {
  CamProblem problem = translating_roller({}, {}, 8);
  problem.motion = {segment(cam::MotionLaw::cycloidal, 180, 25),
                    segment(cam::MotionLaw::cycloidal, 180, -25)};
  problem.length(problems::CamDimension::base_radius).bounds = {9, 60};
  problem.length(problems::CamDimension::offset).bounds = {50, 70};
  problem.constraints.pressure_angle_max = 30 * kDegree;
  problem.solve.starts = 1;
  const auto result = solve(problem, {.threads = 1, .time_limit = 30});
  EXPECT_EQ(result.status, problems::Status::infeasible);
}

// From some starts the solver reaches a smaller pressure angle by a motion of more than a turn.
TEST(CamSearch, FreeAnglesMakeOneTurn) {
  const auto problem = problems::parse_task<problems::CamProblem>(R"(
    kind = "cam"
    follower = {type = "translating-roller", roller_radius = 6}
    target = {objective = "pressure-angle"}
    mechanism = {base_radius = 45, offset = 0}
    [[motion]]
    law = "universal"
    over_deg = [80, 140]
    rise = 25
    sine = [0.125, 0.25]
    constant = [1e-09, 0.25]
    cosine = [0.35, 0.5]
    [[motion]]
    law = "dwell"
    over_deg = 60
    [[motion]]
    law = "modified-sine"
    over_deg = [80, 140]
    rise = -25
    [[motion]]
    law = "dwell"
    over_deg = [60, 120])");
  ASSERT_TRUE(problem);
  const auto result = solve(*problem, {.threads = 1});
  EXPECT_EQ(result.status, problems::Status::solved);
  double turn = 0;
  for (const auto& segment : result.designs.at(0).motion) turn += segment.over;
  EXPECT_NEAR(turn, 360 * kDegree, 1e-9);
}

// The half planes know nothing of the roller: the cam that they give may be smaller than it, where
// any large cam keeps the limits.
TEST(CamSearch, RollerLargerThanTheHalfPlanesAllow) {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> limit(40, 50), stroke(5, 20), enlarged(1.05, 1.5);
  constexpr int kProblems = 12;
  int searched = 0;
  for (int i = 0; i < kProblems; ++i) {
    CamProblem problem = translating_roller({}, {}, 1e-3);
    problem.motion = {segment(cam::MotionLaw::constant_acceleration, 137, stroke(random)), {}};
    problem.motion[1] = segment(cam::MotionLaw::harmonic, 223, -problem.motion[0].rise);
    problem.constraints.curvature_radius_min.reset();
    problem.constraints.pressure_angle_max = limit(random) * kDegree;
    const double least = base_radius(solve(problem, {.threads = 1}));
    const double roller = enlarged(random) * least;
    if (i % 2 == 0) problem.constraints.curvature_radius_min = 0;

    CamProblem planted = problem;
    use(planted, problems::CamDimension::base_radius, 20 * problem.motion[0].rise);
    use(planted, problems::CamDimension::offset, 0.0);
    use(planted, problems::CamDimension::roller_radius, roller);
    ASSERT_EQ(solve(planted, {.threads = 1}).status, problems::Status::solved) << i;

    use(problem, problems::CamDimension::roller_radius, roller);
    const auto found = solve(problem, {.threads = 1});
    EXPECT_EQ(found.status, problems::Status::solved) << i;
    EXPECT_GT(base_radius(found), roller) << i;
    EXPECT_LT(base_radius(found), base_radius(solve(planted, {.threads = 1}))) << i;
    ++searched;
  }
  EXPECT_EQ(searched, kProblems);
}

}  // namespace
}  // namespace cognate::cam_search_test
