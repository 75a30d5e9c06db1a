/// The model of a guided body whose links are off: exact derivatives, and errors that are those of
/// the test's own triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/guidance/toleranced_model.hpp"
#include "synthesis/optimise/check_derivatives.hpp"
#include "tests/support/changed_four_bar.hpp"

namespace cognate::problems::toleranced_motion_model_test {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;

/// A linkage, its body turned by `kTurned` in the coupler, and the crank angles of six poses.
const FourBar kBar{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.8, 1.6, Assembly::open, Vec2d{0.5, 0.4}};
constexpr double kTurned = 0.3;
const std::vector<double> kCranks{0.3, 0.8, 1.3, 1.9, 2.4, 2.9};

DyadPair pair_of(const FourBar& bar) {
  const Vec2d back = unit_vector(-kTurned);
  const auto in_body = [&](const Vec2d& in_link) { return back * (in_link - *bar.coupler_point); };
  return {
      GuidingDyad{DyadKind::rr, in_body({0, 0}), {}, bar.pivot_a, {1, 0}, bar.crank},
      GuidingDyad{DyadKind::rr, in_body({bar.coupler, 0}), {}, bar.pivot_d, {1, 0}, bar.rocker}};
}

MotionProblem problem_of(const FourBar& bar) {
  MotionProblem problem;
  problem.method = MotionMethod::least_squares;
  for (const double crank : kCranks) {
    const auto body = test::changed_body(bar, std::vector<double>(6), crank);
    problem.poses.push_back({body.at, body.angle + kTurned});
  }
  problem.angle_weight = 0.7;
  problem.dyads = {DyadKind::rr};
  return problem;
}

std::vector<double> variables_of(const TolerancedMotionModel& model, const FourBar& bar) {
  const MotionModel& nominal = model.nominal();
  return model.with_no_changes(nominal.with_angles(nominal.variables_of(pair_of(bar)), kCranks));
}

TEST(TolerancedMotionModel, HasExactDerivatives) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> disturbance(-0.04, 0.04);
  const MotionProblem free = problem_of(kBar);
  MotionProblem limited = free;
  limited.constraints.required_class = RequiredClass::triple_rocker;
  limited.constraints.transmission_angle = Range{0.5, 2.4};
  limited.bounds.coupler = Range{0.5, 4};
  int compared = 0;
  for (const MotionProblem& problem : {free, limited}) {
    MotionForm form = form_of(problem, pair_of(kBar));
    if (problem.constraints.transmission_angle) form.stations = {0, 1, 2, 3, 4, 5};
    const TolerancedMotionModel model(problem, form);
    EXPECT_EQ(model.global_count(), problem.constraints.transmission_angle ? 18 : 16);
    auto x = variables_of(model, kBar);
    for (double& value : x) value += disturbance(random);
    const auto error = synthesis::check_derivatives(model, x);
    ASSERT_TRUE(error.has_value);
    EXPECT_LT(error.relative, 1e-7) << error.describe(model);
    EXPECT_EQ(model.without_changes(model.with_no_changes(model.without_changes(x))),
              model.without_changes(x));
    ++compared;
  }
  EXPECT_EQ(compared, 2);
}

TEST(TolerancedMotionModel, ErrsAsTrianglesOfTheChangedLinks) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> off(-0.1, 0.1);
  const MotionProblem problem = problem_of(kBar);
  const TolerancedMotionModel model(problem, form_of(problem, pair_of(kBar)));
  std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
  int compared = 0;
  for (int k = 0; k < 200; ++k) {
    std::vector<double> changes(TolerancedMotionModel::changes);
    for (double& change : changes) change = off(random);
    auto x = variables_of(model, kBar);
    std::ranges::copy(changes, x.begin() + static_cast<std::ptrdiff_t>(
                                               model.variable_of(TolerancedMotionModel::crank)));
    ASSERT_TRUE(model.residuals(x, r, {}, {}));
    for (std::size_t j = 0; j < kCranks.size(); ++j) {
      const auto body = test::changed_body(kBar, changes, kCranks[j]);
      EXPECT_NEAR(r[3 * j], body.at.x - problem.poses[j].at.x, 1e-12);
      EXPECT_NEAR(r[3 * j + 1], body.at.y - problem.poses[j].at.y, 1e-12);
      EXPECT_NEAR(r[3 * j + 2],
                  0.7 * std::remainder(body.angle + kTurned - problem.poses[j].angle, kTurn),
                  1e-12);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 1200);
}

TEST(TolerancedMotionModel, HasNoValueWhereNothingIsLeftOfALink) {
  const MotionProblem problem = problem_of(kBar);
  const TolerancedMotionModel model(problem, form_of(problem, pair_of(kBar)));
  std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
  for (const auto link : {TolerancedMotionModel::crank, TolerancedMotionModel::coupler,
                          TolerancedMotionModel::rocker, TolerancedMotionModel::frame}) {
    auto x = variables_of(model, kBar);
    EXPECT_TRUE(model.residuals(x, r, {}, {}));
    x[model.variable_of(link)] = -3;
    EXPECT_FALSE(model.residuals(x, r, {}, {})) << link;
  }
}

}  // namespace
}  // namespace cognate::problems::toleranced_motion_model_test
