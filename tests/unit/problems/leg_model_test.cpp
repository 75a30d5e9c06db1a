/// Models of legs: their derivatives against differences, and what they say of published legs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/mechanism/gait.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/leg/checks.hpp"
#include "problems/leg/model.hpp"
#include "problems/leg/starts.hpp"
#include "problems/leg/verify.hpp"
#include "synthesis/optimise/check_derivatives.hpp"

namespace cognate::problems::leg_model_test {
namespace {

LegProblem problem_of(const char* type, LegObjective objective) {
  LegProblem problem;
  problem.mechanism = type;
  problem.topologies = leg_topologies(type);
  problem.target = {.duty = 0.55,
                    .stride = 200,
                    .height_min = 80,
                    .height_max = 120,
                    .flatness_max = 0.04,
                    .objective = objective};
  problem.constraints = {{0.5, kPi - 0.5}, -0.5, 2.0};
  return problem;
}

TEST(LegModel, DerivativesAreThoseOfTheValues) {
  int checked = 0;
  for (const char* type : {"klann", "jansen"}) {
    for (const auto objective : {LegObjective::flatness, LegObjective::duty}) {
      SCOPED_TRACE(type);
      LegProblem problem = problem_of(type, objective);
      problem.near = 1.5;
      const LegSpace space(problem, problem.topologies.front());
      const auto leg = with_stance(space, *space.known);
      ASSERT_TRUE(leg);
      LegChecks checks{.transmission = {{space.joints[0], 1.0}, {space.joints[1], 4.0}},
                       .swing = {2.5, 3.5},
                       .bottom = 5,
                       .top = 2,
                       .ahead = 0.93,
                       .behind = 0.08,
                       .slow = {0.02, 0.9},
                       .fast = {0.4},
                       .sense = -1,
                       .band = 0.03};
      const LegModel model(space, *leg, checks, 9, 0.02, objective);
      EXPECT_EQ(model.equality_count(), 2);
      const auto error = synthesis::check_derivatives(model, model.start());
      ASSERT_TRUE(error.has_value);
      EXPECT_LT(error.relative, 1e-6) << error.describe(model);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 4);
}

TEST(LegModel, ResidualsAreTheBandOfTheGait) {
  int checked = 0;
  for (const char* type : {"klann", "jansen"}) {
    const LegProblem problem = problem_of(type, LegObjective::flatness);
    const LegSpace space(problem, problem.topologies.front());
    const auto leg = with_stance(space, *space.known);
    ASSERT_TRUE(leg);
    const LegModel model(space, *leg, {}, 129, 1, LegObjective::flatness);
    std::vector<double> residuals(static_cast<std::size_t>(model.residual_count()));
    ASSERT_TRUE(model.residuals(model.start(), residuals, {}, {}));
    double most = 0;
    for (const double one : residuals) most = std::max(most, std::abs(one));
    const auto mechanism =
        named(problem.topologies.front(), space.scale.out_of(space.chain, leg->chain));
    const Design design = verified(problem, problem.topologies.front(), mechanism, 0.55);
    // The published legs have a stride of about 1 at 15 % of their height, the unit of the space.
    EXPECT_NEAR(design.error.max, 200 * most, 0.1) << type;
    EXPECT_NEAR(half_band(space, *leg), most, 1e-4) << type;
    ++checked;
  }
  EXPECT_EQ(checked, 2);
}

/// By how much the published legs miss limits set around what they reach.
TEST(LegChecks, SayWhatIsViolated) {
  LegProblem problem = problem_of("klann", LegObjective::flatness);
  problem.target.duty = 0.5394;
  problem.target.height_min = 0.52 * 200;
  problem.target.height_max = 0.53 * 200;
  problem.constraints = {{29.2 * kPi / 180, kPi - 29.2 * kPi / 180}, -0.52, {}};
  const auto violation_of = [&] {
    const LegSpace space(problem, problem.topologies.front());
    double violation = 0;
    leg_checks(space, *with_stance(space, *space.known), violation);
    return violation;
  };
  EXPECT_LT(violation_of(), 1e-4);
  problem.target.height_min = 0.6 * 200;
  EXPECT_NEAR(violation_of(), 0.6 - 0.5273 / 1.0087, 1e-3);
  problem.target.height_min.reset();
  problem.constraints.foot_speed_min = 0;
  EXPECT_NEAR(violation_of(), 0.4905, 2e-3);
  problem.constraints.foot_speed_min.reset();
  problem.constraints.transmission_angle = {kPi / 4, 3 * kPi / 4};
  EXPECT_NEAR(violation_of(), std::cos(29.3 * kPi / 180) - std::sqrt(0.5), 2e-3);
}

/// Of plates both distances of their point count, of the frame those from the crank's pivot.
TEST(LegSpace, NearLimitsDistances) {
  int checked = 0;
  for (const char* type : {"klann", "jansen"}) {
    LegProblem problem = problem_of(type, LegObjective::flatness);
    problem.constraints = {};
    problem.target.height_min = problem.target.height_max = {};
    problem.near = 1.5;
    const LegSpace space(problem, problem.topologies.front());
    EXPECT_EQ(space.distances.size(), type == std::string("klann") ? 6U : 5U);
    auto leg = with_stance(space, *space.known);
    ASSERT_TRUE(leg);
    double violation = 0;
    leg_checks(space, *leg, violation);
    EXPECT_LT(violation, 1e-4) << type;
    const auto foot = static_cast<std::size_t>(space.lines.back().parameter);
    leg->chain.parameters[foot] *= 2;
    leg->chain.parameters[foot + 1] *= 2;
    leg_checks(space, *leg, violation);
    EXPECT_GT(violation, 0.3) << type;
    ++checked;
  }
  EXPECT_EQ(checked, 2);
}

}  // namespace
}  // namespace cognate::problems::leg_model_test
