/// A cam problem as a model: its derivatives, and the relaxation it is.
#include <gtest/gtest.h>

#include "problems/cam/model.hpp"
#include "synthesis/optimise/check_derivatives.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::cam_model_test {
namespace {

using problems::CamDimension;
using problems::CamModel;
using problems::CamObjective;
using problems::CamProblem;

/// Every limit of the problem at some positions of every segment.
problems::CamPlaces places_of(const CamProblem& problem) {
  std::vector<problems::SegmentPlace> places;
  for (int segment = 0; segment < int(problem.motion.size()); ++segment) {
    for (const double share : {0.13, 0.4, 0.77}) places.push_back({segment, share});
  }
  problems::CamPlaces all;
  for (const auto& limit : cam_limits(problem)) all.limits.push_back({limit, places});
  if (problem.objective != CamObjective::size) all.objective = places;
  if (problem.constraints.face_width_max) all.face = {{places[1], places[4]}};
  return all;
}

void check(const CamProblem& problem, const std::vector<double>& x) {
  const problems::CamVariables variables(problem);
  const CamModel model(variables, places_of(problem), 2);
  ASSERT_EQ(x.size(), model.variables().size());
  const auto error = synthesis::check_derivatives(model, x);
  EXPECT_TRUE(error.has_value);
  EXPECT_LT(error.relative, 1e-7) << error.describe(model);
}

void demand_everything(CamProblem& problem) {
  auto& c = problem.constraints;
  c.pressure_angle_max = 0.7;
  c.pressure_angle_max_rise = 0.5;
  c.pressure_angle_max_return = 0.6;
  c.curvature_radius_min = 1.5;
  c.concave_radius_min = 30;
  c.profile_radius_min = 5;
  c.profile_radius_max = 90;
  c.contact_force_max = 500;
  c.torque_max = 100;
  c.contact_stress_max = 1e4;
  problem.operation = {3, 2, 40, 20, 10, 0.5, 1e-3};
  problem.preload = 20;
  problem.has_operation = problem.has_contact = true;
}

TEST(CamModel, DerivativesForTranslatingRollers) {
  std::mt19937_64 random(11);
  CamProblem problem = translating_roller({}, {}, {});
  demand_everything(problem);
  problem.motion = random_motion(random, 20);
  for (const auto objective :
       {CamObjective::size, CamObjective::pressure_angle, CamObjective::contact_force,
        CamObjective::torque, CamObjective::contact_stress}) {
    problem.objective = objective;
    check(problem, {48, 7, 6});
  }
  problem.second.closure = cam::Closure::groove;
  problem.operation.preload = -60;
  check(problem, {48, -7, 6});
}

TEST(CamModel, DerivativesForOscillatingRollers) {
  std::mt19937_64 random(12);
  CamProblem problem = oscillating_roller({}, {}, {}, 6);
  demand_everything(problem);
  for (const auto side : {cam::ArmSide::trailing, cam::ArmSide::leading}) {
    problem.side = side;
    problem.motion = random_motion(random, 0.3);
    check(problem, {0.6, 80, 60});
  }
  problem = oscillating_roller(45, {}, {}, 6);
  demand_everything(problem);
  problem.motion = random_motion(random, 0.3);
  check(problem, {80, 60});
}

TEST(CamModel, DerivativesForFlatFaces) {
  std::mt19937_64 random(13);
  CamProblem problem;
  problem.follower = cam::FollowerType::oscillating_flat;
  use(problem, CamDimension::base_radius);
  use(problem, CamDimension::centre_distance);
  use(problem, CamDimension::face_offset);
  demand_everything(problem);
  problem.constraints.concave_radius_min.reset();
  problem.constraints.face_width_max = 30;
  problem.motion = random_motion(random, 0.1);
  check(problem, {0.5, 90, 4});
}

TEST(CamModel, DerivativesByTheMotion) {
  using problems::MotionParameter;
  CamProblem problem = translating_roller({}, 3, 6);
  demand_everything(problem);
  problem.objective = CamObjective::contact_force;
  auto universal = segment(cam::MotionLaw::universal, 100, 20);
  universal.shape = {0.2, 0.3, 0.35};
  problem.motion = {universal, segment(cam::MotionLaw::cycloidal, 120, -20),
                    segment(cam::MotionLaw::dwell, 140)};
  problem.free_motion = {{0, MotionParameter::over, {1, 2}},
                         {0, MotionParameter::sine, {0.1, 0.3}},
                         {0, MotionParameter::constant, {0.1, 0.4}},
                         {0, MotionParameter::cosine, {0.1, 0.4}},
                         {1, MotionParameter::over, {1, 3}}};
  check(problem, {50, 100 * kDegree, 0.2, 0.3, 0.35, 120 * kDegree});
}

// What the variables make is what they were made of.
TEST(CamVariables, ValuesMakeTheDimensions) {
  const CamProblem all[] = {translating_roller({}, {}, {}), oscillating_roller({}, {}, {}, 5)};
  for (CamProblem problem : all) {
    std::mt19937_64 random(14);
    problem.motion = random_motion(random, 0.3);
    cam::CamDimensions<double> d;
    d.base_radius = 41;
    d.offset = is_oscillating(problem.follower) ? 0 : -7;
    d.roller_radius = 5;
    if (is_oscillating(problem.follower)) d.centre_distance = 90, d.arm = 70;
    const problems::CamVariables variables(problem);
    const auto system = variables.system<double>(variables.values(d));
    EXPECT_NEAR(system.follower.dimensions.base_radius, 41, 1e-13 * 41);
    EXPECT_EQ(system.follower.dimensions.offset, d.offset);
    EXPECT_EQ(system.follower.dimensions.centre_distance, d.centre_distance);
  }
}

}  // namespace
}  // namespace cognate::cam_model_test
