/// Cams from their files: values, defaults, and every fault at its place.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <string>

#include "analysis/cam/motion_programme.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/read.hpp"
#include "tests/reading/fault_cases.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems {
namespace {

const std::string kRise = "{law = \"harmonic\", over_deg = 120, rise = 20}";
const std::string kReturn = "{law = \"3-4-5\", over_deg = 150, rise = -20}";
const std::string kDwell = "{law = \"dwell\", over_deg = 90}";
const std::string kTurn = "motion = [" + kRise + ", " + kReturn + ", " + kDwell + "]\n";

// `lines` begins with keys of [follower]; the first of them is line 6.
std::string file(const std::string& type, const std::string& lengths, const std::string& lines) {
  return "kind = \"cam\"\n" + kTurn + "mechanism = {" + lengths + "}\n[follower]\ntype = \"" +
         type + "\"\n" + lines;
}

const std::string kGiven = "base_radius = 40, offset = 5, roller_radius = 8";

std::string roller(const std::string& lines) {
  return file("translating-roller", kGiven, lines);
}

// The same with a motion of degrees.
std::string swinging(const std::string& type, const std::string& lengths,
                     const std::string& lines) {
  return "kind = \"cam\"\nmotion = [{law = \"harmonic\", over_deg = 180, rise_deg = 25}, {law = "
         "\"cycloidal\", over_deg = 180, rise_deg = -25}]\nmechanism = {" +
         lengths + "}\n[follower]\ntype = \"" + type + "\"\n" + lines;
}

const std::string kArm = "base_radius = 25, centre_distance = 60, arm = 50, roller_radius = 8";

std::string with_motion(const std::string& motion) {
  return "kind = \"cam\"\nmotion = " + motion + "\nmechanism = {" + kGiven +
         "}\nfollower.type = \"translating-roller\"\n";
}

std::string segments(const std::string& first) {
  return "[" + first + ",\n" + kReturn + ",\n" + kDwell + "]";
}

// A roller's motion with two free angles; `lines` begins with keys of [follower], as in `file`.
std::string free_motion(const std::string& lines) {
  return "kind = \"cam\"\nmotion = [{law = \"cycloid\", over_deg = [80, 280], rise = 20}, {law = "
         "\"cycloid\", over_deg = [80, 280], rise = -20}]\nmechanism = {" +
         kGiven + "}\n[follower]\ntype = \"translating-roller\"\n" + lines;
}

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

// What the second cam of a pair bears can be limited, and so can the force on parallel faces.
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

const std::string kLaw = "{law = \"cycloidal\", over_deg = 120, rise = 20";

const std::string kMaterials = "[contact]\nwidth = 1\nelasticity = [1, 1]\n";
const std::string kBreadth = "closure = \"constant-breadth\"\nload = 1\n";
const std::string kConjugate = "closure = \"conjugate\"\nload = 1\n";

const std::vector<FaultCase> kCases = {
    {"NoFollower",
     "kind = \"cam\"\n" + kTurn,
     {{1, 1, "follower.type is missing; expected \"translating-roller\", \"translating-flat\""}}},
    {"WrongFollower",
     file("translating-rolle", "", ""),
     {{5, 8, "perhaps for \"translating-roller\""}}},
    {"NoMotion",
     "kind = \"cam\"\nfollower.type = \"translating-flat\"\nmechanism.base_radius = 3\n",
     {{1, 1, "motion is missing; expected tables [[motion]]"}}},
    {"AnglesMissing",
     with_motion("[" + kRise + ", " + kReturn + ", {law = \"dwell\", over_deg = 80}]"),
     {{2, 10, "motion has angles that add up to 350 degrees, 10 are missing"}}},
    {"AnglesTooMany",
     with_motion("[" + kRise + ", " + kReturn + ", {law = \"dwell\", over_deg = [91, 95]}]"),
     {{2, 10, "add up to at least 361 degrees, 1 too many"}}},
    {"AnglesOutOfReach",
     with_motion("[" + kRise + ", " + kReturn + ", {law = \"dwell\", over_deg = [50, 80]}]"),
     {{2, 10, "add up to at most 350 degrees, 10 are missing"}}},
    {"ReturnMissing",
     with_motion("[" + kRise + ", {law = \"dwell\", over_deg = 240}]"),
     {{2, 10, "ends 20 above its beginning; a return of rise = -20 is missing"}}},
    {"RiseMissing",
     with_motion("[" + kReturn + ",\n{law = \"dwell\", over_deg = 210}]"),
     {{2, 10, "ends 20 below its beginning; a rise of rise = 20 is missing"},
      {2, 11, "motion[1].rise takes the follower 20 below its beginning"}}},
    {"BelowBase",
     with_motion("[" + kDwell + ",\n" + kReturn + ",\n" + kRise + "]"),
     {{3, 1, "motion[2].rise takes the follower 20 below its beginning"}}},
    {"OnlyDwells",
     with_motion("[{law = \"dwell\", over_deg = 360}]"),
     {{2, 10, "has dwells only"}}},
    {"NoLaw",
     with_motion(segments("{over_deg = 120, rise = 20}")),
     {{2, 11, "motion[1].law is missing; expected \"dwell\""}}},
    {"WrongLaw",
     with_motion(segments("{law = \"harmonik\", over_deg = 120, rise = 20}")),
     {{2, 18, "perhaps for \"harmonic\""}}},
    {"NoAngle",
     with_motion(segments("{law = \"harmonic\", rise = 20}")),
     {{2, 11,
       "motion[1].over_deg is missing; expected an angle in degrees from 1e-6 to 360, or [min, "
       "max]"}}},
    {"AngleTooLarge",
     with_motion(segments("{law = \"harmonic\", over_deg = 361, rise = 20}")),
     {{2, 41, "is 361; expected an angle in degrees"}}},
    {"EmptyAngleRange",
     with_motion(segments("{law = \"harmonic\", over_deg = [9, 3], rise = 20}")),
     {{2, 41, "is empty, 9 > 3"}}},
    {"NoRise",
     with_motion(segments("{law = \"harmonic\", over_deg = 120}")),
     {{2, 11, "motion[1].rise is missing; expected the lift in a rise"}}},
    {"ZeroRise",
     with_motion(segments("{law = \"harmonic\", over_deg = 120, rise = 0}")),
     {{2, 53, "is 0; expected the lift"}}},
    {"RiseOfADwell",
     with_motion(segments("{law = \"dwell\", over_deg = 120, rise = 20}")),
     {{2, 50, "is 20 in a dwell"}}},
    {"RiseInDegrees",
     with_motion(segments("{law = \"harmonic\", over_deg = 120, rise_deg = 20}")),
     {{2, 57, "is an angle, but the follower translates; expected rise"}}},
    {"RiseInLength",
     file("oscillating-roller", kArm, ""),
     {{2, 53, "motion[1].rise is a length, but the follower oscillates; expected rise_deg"},
      {2, 97, "motion[2].rise is a length"}}},
    {"UnknownKey",
     with_motion(segments(kLaw + ", sine = 0.2}")),
     {{2, 58, "unknown key \"sine\" in [motion[1]]; allowed are \"law\", \"over_deg\", \"rise\""}}},
    {"SharesTooLarge",
     with_motion(
         segments("{law = \"universal\", over_deg = 120, rise = 20, sine = 0.5, cosine = 0.75}")),
     {{2, 65, "motion[1].sine + constant + cosine is 1.25; expected 1 at most"}}},
    {"SharesTooLargeAtLeast",
     with_motion(segments("{law = \"universal\", over_deg = 120, rise = 20, sine = [0.5, 0.6], "
                          "cosine = [0.625, 1]}")),
     {{2, 65, "motion[1].sine + constant + cosine is at least 1.125; expected 1 at most"}}},
    {"NoShares",
     with_motion(segments("{law = \"universal\", over_deg = 120, rise = 20}")),
     {{2, 11, "motion[1].sine + constant + cosine is 0"}}},
    {"ShareOutside",
     with_motion(segments("{law = \"universal\", over_deg = 120, rise = 20, sine = [0.5, 2]}")),
     {{2, 71, "entry 2 of motion[1].sine is 2; expected a share from 0 to 1"}}},
    {"NoConditions",
     with_motion(segments("{law = \"polynomial\", over_deg = 120, rise = 20}")),
     {{2, 11, "motion[1].conditions is missing"}}},
    {"RangeOfAPolynomial",
     with_motion(segments("{law = \"polynomial\", over_deg = [1, 2], rise = 20, conditions = []}")),
     {{2, 43, "is a range, but what a polynomial goes through stands at fixed angles"}}},
    {"Conditions",
     with_motion("[{law = \"polynomial\", over_deg = 120, rise = 20, conditions = [\n"
                 "{at_deg = 0, velocity = 0, jerk = 0},\n{velocity = 1},\n{at_deg = 9},\n"
                 "{at_deg = 130, jerk = 0},\n{at_deg = 5, jerk = 0}, {at_deg = 5, jerk = 1}\n]}]"),
     {{3, 1, "motion[1].conditions[1].displacement is given beside another, or velocity"},
      {4, 1, "conditions[2].at_deg is missing; expected an angle in degrees from 0 to 120"},
      {5, 1, "conditions[3].displacement is missing, or velocity"},
      {6, 11, "is 130, beyond the segment; expected an angle from 0 to 120"},
      {7, 35, "is that of another condition on the same derivative"}}},
    {"ConditionAtTheEnd",
     with_motion(segments("{law = \"polynomial\", over_deg = 120, rise = 20, conditions = "
                          "[{at_deg = 120, displacement = 19}]}")),
     {{2, 72, "contradict the segment at its end"}}},
    // Of a parabola the velocity midway is that of its chord.
    {"UnsolvableConditions",
     with_motion(segments("{law = \"polynomial\", over_deg = 120, rise = 20, conditions = "
                          "[{at_deg = 60, velocity = 1}]}")),
     {{2, 72, "have no polynomial of degree 2 that meets them all, or many"}}},
    {"PeriodicBesideOthers",
     with_motion("[{law = \"spline\", over_deg = 360, points = [[90, 1]], periodic = true},\n" +
                 kDwell + "]"),
     {{2, 10, "add up to 450 degrees, 90 too many"},
      {2, 11, "motion[1].periodic is true beside other segments"}}},
    {"WrongConditionOfAnArm",
     "kind = \"cam\"\nmotion = [{law = \"polynomial\", over_deg = 120, conditions = [{at_deg = "
     "60, displacement = 1}]}]\nmechanism = {" +
         kArm + "}\nfollower.type = \"oscillating-roller\"\n",
     {{2, 62, "displacement_deg is missing, or velocity"},
      {2, 76, "unknown key \"displacement\""}}},
    {"NoPoints",
     with_motion(segments("{law = \"spline\", over_deg = 120, rise = 20}")),
     {{2, 11, "motion[1].points is missing; expected an array of [at_deg, displacement]"}}},
    {"PointsOutOfOrder",
     with_motion(
         segments("{law = \"spline\", over_deg = 120, rise = 20, points = [[30, 1], [30, 2]]}")),
     {{2, 74, "entry 2 of motion[1].points stands at 30 degrees"}}},
    {"PointOutside",
     with_motion(segments("{law = \"spline\", over_deg = 120, rise = 20, points = [[120, 1]]}")),
     {{2, 65, "stands at 120 degrees; expected angles that increase, above 0 and below 120"}}},
    {"Degree",
     with_motion(
         segments("{law = \"spline\", over_deg = 120, rise = 20, points = [[12, 1]], degree = 4}")),
     {{2, 84, "is 4; expected 3 or 5"}}},
    {"CubicAcceleration",
     with_motion(
         segments("{law = \"spline\", over_deg = 120, rise = 20, points = [[12, 1]], degree = 3, "
                  "acceleration = [0, 0]}")),
     {{2, 102, "that at the ends of a cubic spline follows"}}},
    {"PeriodicPart",
     with_motion(segments(
         "{law = \"spline\", over_deg = 120, rise = 20, points = [[12, 1]], periodic = true}")),
     {{2, 86, "is true, but the segment is no whole turn"}}},
    // 360/2^80: all that numbers keep of this spline is a piece that may bend as it likes.
    {"PointsTooClose",
     with_motion("[{law = \"spline\", over_deg = 360, points = [[2.9778502051908996e-22, 1]], "
                 "periodic = true}]"),
     {{2, 53,
       "motion[1].points have no spline of degree 5 that can be computed; expected points "
       "farther"}}},
    {"Side", roller("side = \"leading\"\n"), {{6, 8, "a translating roller has no arm"}}},
    {"ClosureOfAFace",
     file("translating-flat", "base_radius = 9", "closure = \"groove\"\n"),
     {{6, 11, "is \"groove\", which a translating flat face does not have; expected a roller"}}},
    {"ClosureOfAnArm",
     swinging("oscillating-roller", kArm, "closure = \"constant-breadth\"\n"),
     {{6, 11, "which an oscillating roller does not have; expected a translating flat face or"}}},
    {"BreadthByForce", roller("breadth = 3\n"), {{6, 11, "belongs to a translating follower"}}},
    {"ArmsMissing",
     swinging("oscillating-roller", kArm, "closure = \"conjugate\"\n"),
     {{4, 1, "follower.arms_deg is missing; expected the angle between the two arms"}}},
    {"ArmsOfASlide", roller("arms_deg = 90\n"), {{6, 12, "belongs to an oscillating follower"}}},
    {"ArmOfASlide",
     file("translating-roller", "base_radius = 9, offset = 1, roller_radius = 1, arm = 3", ""),
     {{3, 68, "mechanism.arm is given, but a translating roller has none; remove it"}}},
    {"RollerOfAFace",
     file("translating-flat", "base_radius = 9", "roller_radius = 1\n"),
     {{6, 17, "follower.roller_radius is given, but a translating flat face has none"}}},
    {"BoundsOfNothing",
     roller("[bounds]\ncentre_distance = [1, 2]\n"),
     {{7, 19, "bounds.centre_distance is given, but a translating roller has none"}}},
    {"LengthTwice", roller("roller_radius = 8\n"), {{3, 60, "is given a second time"}}},
    {"KnifeWithRoller",
     file("translating-knife", "base_radius = 9, offset = 1, roller_radius = 1", ""),
     {{3, 59, "is 1, but a knife edge has none; expected 0"}}},
    {"OutsideBounds",
     roller("[bounds]\nbase_radius = [50, 60]\n"),
     {{3, 28, "is 40, outside its bounds; bounds.base_radius allows [50, 60]"}}},
    {"NegativeBound",
     roller("[bounds]\nbase_radius = [-1, 60]\n"),
     {{7, 16, "is -1; expected 0, a length from 1e-30 to 1e30 or inf"}}},
    {"ZeroBound",
     roller("[bounds]\nbase_radius = [0, 0]\n"),
     {{3, 28, "outside its bounds"}, {7, 15, "is [0, 0]; lengths"}}},
    {"Rotation",
     file("translating-roller", kGiven + ", rotation = \"left\"", ""),
     {{3, 74, "is \"left\"; allowed are \"ccw\", \"cw\""}}},
    {"OffsetTooLarge",
     file("translating-roller", "base_radius = 40, offset = -40, roller_radius = 8", ""),
     {{3, 41, "is -40, so that the follower's line passes the base circle of radius 40"}}},
    {"RollerTooLarge",
     file("translating-roller", "base_radius = 40, offset = 0, roller_radius = 40", ""),
     {{3, 60, "is 40, and base_radius, of the roller's centre, is 40"}}},
    {"ArmOutOfReach",
     swinging("oscillating-roller",
              "base_radius = 10, centre_distance = 60, arm = 50, roller_radius = 8", ""),
     {{3, 28, "carries its roller from 10 to 110 from there"}}},
    {"ArmSwingsOver",
     swinging("oscillating-roller",
              "base_radius = 109, centre_distance = 60, arm = 50, roller_radius = 8", ""),
     {{3, 51, "at 164.472 degrees from the line of centres on the base circle and at 189.472"}}},
    {"FaceOutOfReach",
     swinging("oscillating-flat", "base_radius = 25, centre_distance = 30, face_offset = 5", ""),
     {{3, 28, "cannot touch the base circle; expected a sum of less than 30"}}},
    {"FaceSwingsOver",
     swinging("oscillating-flat", "base_radius = 29, centre_distance = 31", ""),
     {{3, 50, "at 69.3065 degrees from the line of centres on the base circle and at 94.3065"}}},
    {"SwingTooWide",
     "kind = \"cam\"\nmotion = [{law = \"cycloid\", over_deg = 90, rise_deg = 100}, {law = "
     "\"cycloid\", over_deg = 90, rise_deg = 90}, {law = \"harmonic\", over_deg = 90, rise_deg = "
     "-100}, {law = \"harmonic\", over_deg = 90, rise_deg = -90}]\nmechanism = {" +
         kArm + "}\nfollower.type = \"oscillating-roller\"\n",
     {{4, 17, "which the motion swings by 190 degrees; expected less than 180"}}},
    {"OffsetOfOppositeRollers",
     roller("closure = \"constant-breadth\"\n"),
     {{3, 41, "is 5, but the second roller of closure = \"constant-breadth\" would stand"}}},
    {"MassOfAnArm",
     swinging("oscillating-roller", kArm, "mass = 1\n"),
     {{6, 8, "is given, but the follower oscillates; expected inertia about its pivot"}}},
    {"InertiaOfASlide",
     roller("inertia = 1\n"),
     {{6, 11, "the follower translates; expected mass"}}},
    {"MassWithoutSpeed",
     roller("mass = 1\n"),
     {{1, 1, "drive.speed is missing, without which follower.mass presses on nothing"}}},
    {"Standstill", roller("[drive]\nspeed = 0\n"), {{7, 9, "a speed in rad/s from 1e-30"}}},
    {"ContactWithoutForce",
     roller("[contact]\nwidth = 1\nelasticity = [1, 1]\n"),
     {{6, 1,
       "nothing presses the follower on the cam; expected follower.mass (with drive.speed), "
       "spring_rate, preload or load as well"}}},
    {"HalfAContact",
     roller("load = 1\n[contact]\npoisson = [0.3, 0.6]\n"),
     {{7, 1, "contact.width is missing"},
      {7, 1, "contact.elasticity is missing; expected [E1, E2]"},
      {8, 17, "a ratio from 0 to 0.5"}}},
    {"ContactOfAKnife",
     file("translating-knife", "base_radius = 9, offset = 1",
          "load = 1\n[contact]\nwidth = 1\nelasticity = [1, 1]\n"),
     {{7, 1, "a knife edge presses without limit"}}},
    {"LimitsWithoutForces",
     roller("[constraints]\ncontact_force_max = 1\ntorque_max = 1\ncontact_stress_max = 1\n"
            "no_separation = true\n"),
     {{7, 21,
       "constraints.contact_force_max is given without what it follows from; expected "
       "follower.mass "
       "(with drive.speed), spring_rate, preload or load"},
      {8, 14, "torque_max is given without"},
      {9, 22, "preload or load, contact.width and contact.elasticity"},
      {10, 17, "no_separation is given without"}}},
    {"StressWithoutContact",
     roller("load = 1\n[target]\nobjective = \"contact-stress\"\n"),
     {{8, 13,
       "given without what it follows from; expected contact.width and contact.elasticity"}}},
    {"StressOfAKnife",
     file("translating-knife", "base_radius = 9, offset = 1",
          "load = 1\n[constraints]\ncontact_stress_max = 9\n"),
     {{8, 22, "a translating knife edge presses without limit"}}},
    {"SeparationInAGroove",
     roller("closure = \"groove\"\nload = 1\n[constraints]\nno_separation = true\n"),
     {{9, 17, "closure = \"groove\" lets nothing separate"}}},
    {"PreloadOfAFreeMotion",
     free_motion("load = 1\n[target]\nobjective = \"torque\"\n"),
     {{4, 1, "follower.preload is missing; expected a number, since forces are limited"}}},
    {"PreloadOfAFreeMotionByItsForce",
     free_motion("load = 1\n[target]\nobjective = \"contact-force\"\n"),
     {{4, 1, "follower.preload is missing"}}},
    {"PreloadOfAFreeMotionByItsStress",
     free_motion("load = 1\n" + kMaterials + "[target]\nobjective = \"contact-stress\"\n"),
     {{4, 1, "follower.preload is missing"}}},
    {"PreloadOfALimitedForce",
     free_motion("load = 1\n[constraints]\ncontact_force_max = 9\n"),
     {{4, 1, "follower.preload is missing"}}},
    {"PreloadOfALimitedTorque",
     free_motion("load = 1\n[constraints]\ntorque_max = 9\n"),
     {{4, 1, "follower.preload is missing"}}},
    {"PreloadOfALimitedStress",
     free_motion("load = 1\n" + kMaterials + "[constraints]\ncontact_stress_max = 9\n"),
     {{4, 1, "follower.preload is missing"}}},
    {"StressOfOppositeFaces",
     file("translating-flat", "base_radius = 9",
          kBreadth + kMaterials +
              "[constraints]\ncontact_stress_max = 9\n[target]\nobjective = "
              "\"contact-stress\"\n"),
     {{12, 22,
       "is given, but with closure = \"constant-breadth\" the curvature of the second contact is "
       "not judged; remove it"},
      {14, 13,
       "is \"contact-stress\", but with closure = \"constant-breadth\" the second contact would "
       "not be judged; expected another objective"}}},
    {"ForceOfOppositeRollers",
     file("translating-roller", "base_radius = 40, roller_radius = 8",
          kBreadth + "[constraints]\ncontact_force_max = 9\n[target]\nobjective = "
                     "\"contact-force\"\n"),
     {{9, 21, "the pressure angle of the second contact is not judged; remove it"},
      {11, 13, "is \"contact-force\", but with closure = \"constant-breadth\" the second"}}},
    {"ForceOfAPair",
     roller(kConjugate + "[target]\nobjective = \"contact-force\"\n"),
     {{9, 13,
       "is \"contact-force\", but with closure = \"conjugate\" only the first of both cams would "
       "be judged; expected another objective"}}},
    {"StressOfAPair",
     roller(kConjugate + kMaterials + "[target]\nobjective = \"contact-stress\"\n"),
     {{12, 13, "is \"contact-stress\", but with closure = \"conjugate\" only the first"}}},
    {"Undercut",
     roller("[constraints]\ncurvature_radius_min = 1\nno_undercut = false\n"),
     {{8, 15, "is false beside curvature_radius_min"}}},
    {"ConcaveFace",
     file("translating-flat", "base_radius = 9", "[constraints]\nconcave_radius_min = 1\n"),
     {{7, 22, "a translating flat face touches no concave profile"}}},
    {"FaceOfARoller", roller("[constraints]\nface_width_max = 1\n"), {{7, 18, "has no face"}}},
    {"ProfileRadii",
     roller("[constraints]\nprofile_radius_min = 3\nprofile_radius_max = 2\n"),
     {{7, 22, "is 3, more than profile_radius_max = 2"}}},
    {"PressureAngle",
     roller("[constraints]\npressure_angle_deg_max = 90\n"),
     {{7, 26, "from 0.001 to 89.999"}}},
    {"PressureAngleOfAFace",
     file("translating-flat", "base_radius = 9", "[target]\nobjective = \"pressure-angle\"\n"),
     {{7, 13, "is 0 for a translating flat face for any cam"}}},
    {"Solver",
     roller("[solve]\nsolver = \"ceres\"\ncertify = true\n"),
     {{7, 10, "which minimises sums of squares"}, {8, 1, "unknown key \"certify\" in [solve]"}}},
    {"Shrinks",
     file("translating-roller", "offset = 0", "[constraints]\nno_undercut = false\n"),
     {{3, 13, "nothing keeps this cam from shrinking to nothing; give a limit on the pressure"}}},
    {"ForceOfAFaceLimitsNoSize",
     file("translating-flat", "",
          "load = 1\n[constraints]\nno_undercut = false\ncontact_force_max = 3\n"),
     {{3, 13, "nothing keeps this cam from shrinking to nothing"}}},
    {"Grows",
     file("translating-roller", "offset = 0, roller_radius = 3",
          "[target]\nobjective = \"pressure-angle\"\n"),
     {{3, 13, "the objective is the less the larger the cam is; expected an upper bound"}}},
    {"NoLength",
     swinging("oscillating-roller", "", "[constraints]\npressure_angle_deg_max = 30\n"),
     {{3, 13, "so is every other length, and angles alone do not say how large a cam is"}}},
};

class CamFaults : public testing::TestWithParam<FaultCase> {};

TEST_P(CamFaults, AreFound) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(CamProblem, CamFaults, testing::ValuesIn(kCases), name_of_case);

}  // namespace
}  // namespace cognate::problems
