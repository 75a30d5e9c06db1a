/// Cams from their files: values and defaults.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <string>

#include "analysis/cam/motion_programme.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/read.hpp"
#include "tests/reading/cam_files.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::cam_problem_test {
namespace {

using namespace cam_files;

CamProblem read_or_fail(const std::string& text) {
  auto problem = parse_task<CamProblem>(text);
  if (problem) return *std::move(problem);
  for (const Fault& fault : problem.error()) {
    ADD_FAILURE() << fault.line << ":" << fault.column << ": " << fault.message << "\n" << text;
  }
  return {};
}

TEST(CamProblem, DefaultsOfWhatAFileDoesNotSay) {
  const CamProblem problem = read_or_fail(roller(""));
  EXPECT_EQ(problem.follower, cam::FollowerType::translating_roller);
  EXPECT_EQ(problem.side, cam::ArmSide::trailing);
  EXPECT_EQ(problem.second.closure, cam::Closure::force);
  EXPECT_FALSE(problem.clockwise);
  EXPECT_FALSE(problem.has_operation);
  EXPECT_FALSE(problem.has_contact);
  EXPECT_EQ(problem.objective, CamObjective::size);
  EXPECT_EQ(problem.constraints.curvature_radius_min, 0.0);
  EXPECT_FALSE(problem.constraints.pressure_angle_max);
  EXPECT_EQ(problem.solve.designs, 1);
  EXPECT_TRUE(problem.free_motion.empty());
  EXPECT_EQ(problem.length(CamDimension::base_radius).given, 40);
  EXPECT_EQ(problem.length(CamDimension::offset).given, 5);
  EXPECT_FALSE(problem.length(CamDimension::arm).used);
  EXPECT_FALSE(problem.length(CamDimension::centre_distance).used);
}

TEST(CamProblem, SegmentsInRadiansAndInTheirOrder) {
  const CamProblem problem = read_or_fail(roller(""));
  ASSERT_EQ(problem.motion.size(), 3U);
  EXPECT_EQ(problem.motion[0].law, cam::MotionLaw::harmonic);
  EXPECT_DOUBLE_EQ(problem.motion[0].over, 120 * kDegree);
  EXPECT_EQ(problem.motion[0].rise, 20);
  EXPECT_EQ(problem.motion[1].law, cam::MotionLaw::polynomial_345);
  EXPECT_EQ(problem.motion[1].rise, -20);
  EXPECT_EQ(problem.motion[2].rise, 0);
  const CamProblem arm = read_or_fail(swinging("oscillating-roller", kArm, ""));
  EXPECT_DOUBLE_EQ(arm.motion[0].rise, 25 * kDegree);
  EXPECT_EQ(arm.length(CamDimension::arm).given, 50);
}

TEST(CamProblem, WhatIsNotGivenIsFreeWithinItsBounds) {
  const CamProblem problem = read_or_fail(
      file("translating-roller", "",
           "roller_radius = 8\n[bounds]\nbase_radius = [20, inf]\noffset = [-inf, 9]\n"));
  const CamLength& base = problem.length(CamDimension::base_radius);
  EXPECT_TRUE(base.used);
  EXPECT_FALSE(base.given);
  EXPECT_EQ(base.bounds.min, 20);
  EXPECT_EQ(base.bounds.max, HUGE_VAL);
  EXPECT_EQ(problem.length(CamDimension::offset).bounds.min, -HUGE_VAL);
  EXPECT_EQ(problem.length(CamDimension::offset).bounds.max, 9);
  EXPECT_EQ(problem.length(CamDimension::roller_radius).given, 8);
}

TEST(CamProblem, FacesHaveTheirOwnDefaults) {
  const CamProblem flat = read_or_fail(file("translating-flat", "base_radius = 9", ""));
  EXPECT_EQ(flat.length(CamDimension::offset).given, 0);
  EXPECT_FALSE(flat.length(CamDimension::roller_radius).used);
  const std::string face = "base_radius = 25, centre_distance = 80";
  const CamProblem through = read_or_fail(swinging("oscillating-flat", face, ""));
  EXPECT_EQ(through.length(CamDimension::face_offset).given, 0);
  const CamProblem free =
      read_or_fail(swinging("oscillating-flat", face, "[bounds]\nface_offset = [-5, 5]\n"));
  EXPECT_FALSE(free.length(CamDimension::face_offset).given);
  const CamProblem knife =
      read_or_fail(file("translating-knife", "base_radius = 9, offset = 0, roller_radius = 0", ""));
  EXPECT_EQ(knife.length(CamDimension::roller_radius).given, 0);
}

// Two rollers face each other on a line through the cam's centre, a single one may be set off.
TEST(CamProblem, TheLineOfOppositeRollersGoesThroughTheCentre) {
  const CamProblem problem =
      read_or_fail(file("translating-roller", "base_radius = 40, roller_radius = 8",
                        "closure = \"constant-breadth\"\n"));
  EXPECT_EQ(problem.length(CamDimension::offset).given, 0);
  read_or_fail(file("translating-roller", "base_radius = 40, roller_radius = 8, offset = 0",
                    "closure = \"constant-breadth\"\n"));
  const CamProblem one = read_or_fail(
      file("translating-roller", "base_radius = 40, roller_radius = 8", "closure = \"groove\"\n"));
  EXPECT_FALSE(one.length(CamDimension::offset).given);
}

TEST(CamProblem, MassesSpringAndMaterials) {
  const CamProblem problem = read_or_fail(
      roller("mass = 0.5\nspring_rate = 2e3\nload = -3\n[drive]\nspeed = 100\n"
             "[contact]\nwidth = 0.01\nelasticity = [2e11, 1e11]\npoisson = [0.3, 0.25]\n"));
  EXPECT_TRUE(problem.has_operation);
  EXPECT_TRUE(problem.has_contact);
  EXPECT_EQ(problem.operation.inertia, 0.5);
  EXPECT_EQ(problem.operation.spring_rate, 2e3);
  EXPECT_EQ(problem.operation.load, -3);
  EXPECT_EQ(problem.operation.speed, 100);
  EXPECT_FALSE(problem.preload);
  EXPECT_DOUBLE_EQ(problem.operation.modulus_sum, 0.91 / 2e11 + 0.9375 / 1e11);
  const CamProblem preloaded = read_or_fail(roller("preload = 7\n"));
  EXPECT_EQ(preloaded.preload, 7);
  EXPECT_EQ(preloaded.operation.preload, 7);
  const CamProblem groove =
      read_or_fail(roller("closure = \"groove\"\nmass = 0.5\n[drive]\nspeed = 100\n"));
  EXPECT_EQ(groove.preload, 0) << "a groove needs no spring";
}

TEST(CamProblem, ClosureSideAndRotation) {
  const CamProblem arm = read_or_fail(swinging("oscillating-roller", kArm + ", rotation = \"cw\"",
                                               "side = \"leading\"\nclosure = \"conjugate\"\n"
                                               "arms_deg = 90\n"));
  EXPECT_TRUE(arm.clockwise);
  EXPECT_EQ(arm.side, cam::ArmSide::leading);
  EXPECT_EQ(arm.second.closure, cam::Closure::conjugate);
  EXPECT_DOUBLE_EQ(*arm.second.arms_angle, 90 * kDegree);
  const CamProblem flat = read_or_fail(file("translating-flat", "base_radius = 9",
                                            "closure = \"constant-breadth\"\nbreadth = 38\n"));
  EXPECT_EQ(flat.second.breadth, 38);
}

TEST(CamProblem, LimitsAndObjective) {
  const CamProblem problem = read_or_fail(roller(
      "load = 1\n[constraints]\npressure_angle_deg_max = 30\npressure_angle_deg_max_rise = 25\n"
      "pressure_angle_deg_max_return = 45\npressure_angle_deg_max_rise_working = 20\n"
      "pressure_angle_deg_max_return_working = 40\nno_undercut = false\nconcave_radius_min = 12\n"
      "profile_radius_min = 5\nprofile_radius_max = 90\ncontact_force_max = 4\n"
      "torque_max = 6\nno_separation = false\n[target]\nobjective = \"torque\"\n"
      "[solve]\nsolver = \"slsqp\"\nstarts = 4\ndesigns = 2\n"));
  EXPECT_DOUBLE_EQ(*problem.constraints.pressure_angle_max, 30 * kDegree);
  EXPECT_DOUBLE_EQ(*problem.constraints.pressure_angle_max_rise, 25 * kDegree);
  EXPECT_DOUBLE_EQ(*problem.constraints.pressure_angle_max_return, 45 * kDegree);
  EXPECT_DOUBLE_EQ(*problem.constraints.pressure_angle_max_rise_working, 20 * kDegree);
  EXPECT_DOUBLE_EQ(*problem.constraints.pressure_angle_max_return_working, 40 * kDegree);
  EXPECT_FALSE(problem.constraints.curvature_radius_min);
  EXPECT_EQ(problem.constraints.concave_radius_min, 12);
  EXPECT_EQ(problem.constraints.profile_radius_min, 5);
  EXPECT_EQ(problem.constraints.profile_radius_max, 90);
  EXPECT_EQ(problem.constraints.contact_force_max, 4);
  EXPECT_EQ(problem.constraints.torque_max, 6);
  EXPECT_FALSE(problem.constraints.no_separation);
  EXPECT_EQ(problem.objective, CamObjective::torque);
  EXPECT_EQ(problem.solve.solver, synthesis::Solver::slsqp);
  EXPECT_EQ(problem.solve.designs, 2);
}

// The least preload of a motion that is known is a number; of form closed followers none is
// requested.
TEST(CamProblem, APreloadIsWantedOnlyWhereForcesOfAFreeMotionAreJudged) {
  const std::string limits = "[constraints]\ntorque_max = 6\n";
  EXPECT_FALSE(read_or_fail(roller("load = 1\n" + limits)).preload);
  EXPECT_FALSE(read_or_fail(free_motion("load = 1\n")).preload);
  EXPECT_EQ(read_or_fail(free_motion("preload = 0\n" + limits)).preload, 0);
  read_or_fail(free_motion("closure = \"groove\"\nload = 1\n" + limits));
}

// The load on the second cam of a pair can be limited, and so can the force on parallel faces.
TEST(CamProblem, LimitsThatHoldForTheSecondContact) {
  const std::string contact = "load = 1\n[contact]\nwidth = 1\nelasticity = [1, 1]\n";
  const std::string limits = "[constraints]\ncontact_force_max = 1\n";
  const CamProblem pair =
      read_or_fail(roller("closure = \"conjugate\"\n" + contact + limits +
                          "contact_stress_max = 2\n[target]\nobjective = \"torque\"\n"));
  EXPECT_EQ(pair.constraints.contact_stress_max, 2);
  const CamProblem faces = read_or_fail(file("translating-flat", "base_radius = 9",
                                             "closure = \"constant-breadth\"\n" + contact + limits +
                                                 "[target]\nobjective = \"contact-force\"\n"));
  EXPECT_EQ(faces.constraints.contact_force_max, 1);
}

// 80 to 140 and 30 to 60 beside 180: the turn wants 180 of 110 to 200, 7/9 of each width.
TEST(CamProblem, FreeAnglesHoldValuesThatMakeATurn) {
  const CamProblem problem = read_or_fail(
      with_motion("[{law = \"universal\", over_deg = [80, 140], rise = 5, sine = [0.2, 0.6], "
                  "constant = 0.3, cosine = [0.2, 0.6]}, {law = \"dwell\", over_deg = [30, 60]}, "
                  "{law = \"cycloid\", over_deg = 180, rise = -5}]"));
  ASSERT_EQ(problem.motion.size(), 3U);
  EXPECT_NEAR(problem.motion[0].over, (80 + 60 * 7.0 / 9) * kDegree, 1e-14);
  EXPECT_NEAR(problem.motion[1].over, (30 + 30 * 7.0 / 9) * kDegree, 1e-14);
  ASSERT_EQ(problem.free_motion.size(), 4U);
  EXPECT_EQ(problem.free_motion[0].parameter, MotionParameter::over);
  EXPECT_EQ(problem.free_motion[1].parameter, MotionParameter::sine);
  EXPECT_EQ(problem.free_motion[2].parameter, MotionParameter::cosine);
  EXPECT_EQ(problem.free_motion[3].segment, 1U);
  EXPECT_DOUBLE_EQ(problem.free_motion[3].range.max, 60 * kDegree);
  // The middles, 0.4 each, would be 1.1 with 0.3.
  EXPECT_NEAR(problem.motion[0].shape.sine, 0.35, 1e-15);
  EXPECT_NEAR(problem.motion[0].shape.cosine, 0.35, 1e-15);
  EXPECT_EQ(problem.motion[0].shape.constant, 0.3);
  EXPECT_TRUE(cam::programme_of(problem.motion));
}

// A rise at rest at both ends by conditions is the 3-4-5 polynomial.
TEST(CamProblem, ConditionsOfAPolynomialMeanWhatTheySay) {
  const CamProblem problem = read_or_fail(with_motion(
      segments("{law = \"polynomial\", over_deg = 120, rise = 20, conditions = [{at_deg = 0, "
               "velocity = 0}, {at_deg = 0, acceleration = 0}, {at_deg = 120, velocity = 0}, "
               "{at_deg = 120, acceleration = 0}]}")));
  const auto programme = cam::programme_of(problem.motion);
  ASSERT_TRUE(programme);
  for (const double share : {0.1, 0.35, 0.8}) {
    const double cubes = share * share * share;
    const double s = 20 * cubes * (10 + share * (6 * share - 15));
    EXPECT_NEAR(programme->at(share * 120 * kDegree).displacement, s, 1e-12);
  }
}

TEST(CamProblem, ASplineGoesThroughItsPoints) {
  const CamProblem problem = read_or_fail(with_motion(
      segments("{law = \"spline\", over_deg = 120, rise = 20, points = [[30, 4], [70, 13]], "
               "degree = 3, velocity = [0, 1.5]}")));
  const auto programme = cam::programme_of(problem.motion);
  ASSERT_TRUE(programme);
  EXPECT_NEAR(programme->at(30 * kDegree).displacement, 4, 1e-12);
  EXPECT_NEAR(programme->at(70 * kDegree).displacement, 13, 1e-12);
  EXPECT_NEAR(programme->at(120 * kDegree - 1e-9).velocity, 1.5, 1e-6);
  EXPECT_EQ(problem.motion[0].degree, 3);
}

TEST(CamProblem, ASplineMayDipBelowTheBaseCircle) {
  const CamProblem problem = read_or_fail(
      with_motion(segments("{law = \"spline\", over_deg = 120, rise = 20, points = [[30, -4]]}")));
  const auto programme = cam::programme_of(problem.motion);
  ASSERT_TRUE(programme);
  EXPECT_LE(programme->lowest(), -4);
}

TEST(CamProblem, LawsAreKnownByOtherNamesToo) {
  for (const auto& [name, law] : {std::pair{"parabolic", cam::MotionLaw::constant_acceleration},
                                  {"simple-harmonic", cam::MotionLaw::harmonic},
                                  {"polynomial-345", cam::MotionLaw::polynomial_345},
                                  {"4567", cam::MotionLaw::polynomial_4567},
                                  {"cycloid", cam::MotionLaw::cycloidal}}) {
    const std::string first = "{law = \"" + std::string(name) + "\", over_deg = 120, rise = 20}";
    EXPECT_EQ(read_or_fail(with_motion(segments(first))).motion.at(0).law, law) << name;
  }
}

TEST(CamProblem, AHundredThousandSegmentsAreRead) {
  std::string motion = "[";
  for (int i = 0; i < 50'000; ++i) {
    motion +=
        "{law=\"harmonic\",over_deg=0.0036,rise=1},{law=\"cycloidal\",over_deg=0.0036,rise=-1},";
  }
  const CamProblem problem = read_or_fail(with_motion(motion + "]"));
  EXPECT_EQ(problem.motion.size(), 100'000U);
}

TEST(CamProblem, OtherReadersSayWhatItIs) {
  const auto analysis = parse_task<AnalysisProblem>(roller(""));
  ASSERT_FALSE(analysis);
  EXPECT_EQ(analysis.error()[0].column, 8U);
  EXPECT_EQ(analysis.error()[0].message, "kind is \"cam\"; expected kind = \"analysis\"");
  const auto cam = parse_task<CamProblem>(
      "kind = \"quick-return\"\n[target]\ntime_ratio = 1.5\n[mechanism]\n"
      "type = \"guide-bar\"\nframe = 3\n");
  ASSERT_FALSE(cam);
  EXPECT_NE(cam.error()[0].message.find("expected kind = \"cam\""), std::string::npos);
}

TEST(CamProblem, TheLibraryHasEveryRollerAndFace) {
  std::set<cam::FollowerType> types;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(kLibraryFolder) / "cam")) {
    const auto problem = read_task<CamProblem>(entry.path());
    ASSERT_TRUE(problem) << entry.path();
    EXPECT_FALSE(problem->title.empty()) << entry.path();
    const auto programme = cam::programme_of(problem->motion);
    ASSERT_TRUE(programme) << entry.path();
    EXPECT_GE(programme->lowest(), -1e-12) << entry.path();
    types.insert(problem->follower);
  }
  EXPECT_GE(types.size(), 4U);
}

}  // namespace
}  // namespace cognate::problems::cam_problem_test
