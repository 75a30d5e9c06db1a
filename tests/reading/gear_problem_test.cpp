/// Gears and gear pairs from their files: values, defaults, and every fault at its place.
#include <gtest/gtest.h>

#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/gear/result.hpp"
#include "problems/read.hpp"
#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::gear_problem_test {
namespace {

// `lines` are keys of [mechanism] from line 3 on.
std::string gear(const std::string& lines) {
  return "kind = \"gear\"\n[mechanism]\n" + lines;
}

std::string pair(const std::string& lines) {
  return "kind = \"gear-pair\"\n[mechanism]\n" + lines;
}

const std::string kWhole = "teeth = [20, 80]\nmodule = 5\n";

TEST(GearProblemTest, WhatAGearNeedNotSay) {
  const auto read = parse_task<GearProblem>(gear("teeth = 35\nmodule = 5"));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->gearing, Gearing::spur);
  EXPECT_EQ(read->gear.normal.teeth, 35);
  EXPECT_EQ(read->gear.normal.module, 5);
  EXPECT_EQ(read->gear.normal.profile_shift, 0);
  EXPECT_DOUBLE_EQ(read->gear.normal.rack.pressure_angle, kPi / 9);
  EXPECT_EQ(read->gear.normal.rack.addendum, 1);
  EXPECT_EQ(read->gear.normal.rack.clearance, 0.25);
  EXPECT_EQ(read->points, 20);
}

TEST(GearProblemTest, AHelicalGear) {
  const auto read = parse_task<GearProblem>(
      gear("gearing = \"helical\"\nteeth = 24\nmodule = 3\nhelix_deg = -20\nface_width = 30\n"
           "profile_shift = 0.2\ntip_reduction = 0.1\n[rack]\npressure_angle_deg = 25\n"
           "addendum = 0.9\nclearance = 0.2\n[output]\npoints = 7"));
  ASSERT_TRUE(read);
  EXPECT_DOUBLE_EQ(read->gear.helix, -kPi / 9);
  EXPECT_EQ(read->gear.face_width, 30);
  EXPECT_EQ(read->gear.normal.tip_reduction, 0.1);
  EXPECT_EQ(read->gear.normal.rack.addendum, 0.9);
  EXPECT_EQ(read->points, 7);
}

TEST(GearProblemTest, APairWithOneShiftFree) {
  const auto read = parse_task<GearPairProblem>(
      pair(kWhole + "profile_shift = [0.3, \"free\"]\nbacklash = 0.1\n"
                    "[bounds]\ncentre_distance = [249, inf]\n[target]\n"
                    "objective = \"size\"\n[constraints]\nsliding_max = 3"));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->profile_shift[0], 0.3);
  EXPECT_FALSE(read->profile_shift[1]);
  EXPECT_EQ(read->centre_distance_bounds.min, 249);
  EXPECT_EQ(read->objective, GearObjective::size);
  EXPECT_EQ(read->constraints.sliding_max, 3.0);
  EXPECT_EQ(read->constraints.contact_ratio_min, 1);
  EXPECT_FALSE(is_whole(*read));
}

TEST(GearProblemTest, TeethAndModulesWithinBounds) {
  const auto read = parse_task<GearPairProblem>(
      "kind = \"gear-pair\"\n[bounds]\nteeth = [[17, 40], [40, 120]]\nmodules = [3, 2, 3]\n"
      "[target]\nratio = 3.5\nratio_tolerance = 0.01\n[solve]\ndesigns = 9");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->teeth_bounds[1][1], 120);
  EXPECT_EQ(read->modules, (std::vector<double>{2, 3}));
  EXPECT_EQ(read->ratio, 3.5);
  EXPECT_EQ(read->solve.designs, 9);
}

TEST(GearProblemTest, RacksThatWorkshopsHave) {
  const std::string gear20 = "teeth = 20\nmodule = 1\n[rack]\n";
  const auto profile = parse_task<GearProblem>(gear(gear20 + "clearance = 0.4\ntip_radius = 0.39"));
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->gear.normal.rack.corner_radius, 0.39);
  for (const char* rack : {"clearance = 0.4", "clearance = 0.3", "addendum = 1.2",
                           "pressure_angle_deg = 25", "tip_radius = 0"}) {
    EXPECT_TRUE(parse_task<GearProblem>(gear(gear20 + rack))) << rack;
  }
}

TEST(GearProblemTest, WholeNumbersMayBeWrittenWithAPoint) {
  const auto read = parse_task<GearProblem>(gear("teeth = 35.0\nmodule = 5"));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->gear.normal.teeth, 35);
}

TEST(GearProblemTest, AWorm) {
  const auto read = parse_task<GearPairProblem>(
      pair("gearing = \"worm\"\nstarts = 2\nwheel_teeth = 40\nmodule = 4\nfriction = 0.05"));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->worm.starts, 2);
  EXPECT_EQ(read->worm.module, 4);
  EXPECT_EQ(read->worm.diameter_quotient, 10);
  EXPECT_TRUE(is_whole(*read));
}

class GearFaultTest : public ::testing::TestWithParam<FaultCase> {};

TEST_P(GearFaultTest, IsFoundAtItsPlace) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Gears, GearFaultTest,
    ::testing::Values(
        FaultCase{"NothingGiven",
                  "kind = \"gear\"",
                  {{1, 1, "mechanism.teeth is missing"}, {1, 1, "mechanism.module is missing"}}},
        FaultCase{"BevelAlone",
                  gear("gearing = \"bevel\"\nteeth = 20\nmodule = 2"),
                  {{3, 11, "made in pairs alone"}}},
        FaultCase{"FewTeeth", gear("teeth = 2\nmodule = 1"), {{3, 9, "from 3 to 2000"}}},
        FaultCase{"HalfATooth", gear("teeth = 20.5\nmodule = 1"), {{3, 9, "a whole number"}}},
        FaultCase{"NoModule", gear("teeth = 20\nmodule = 0"), {{4, 10, "from 1e-30 to 1e30"}}},
        FaultCase{"HugeShift",
                  gear("teeth = 20\nmodule = 1\nprofile_shift = 11"),
                  {{5, 17, "from -10 to 10"}}},
        FaultCase{"HelixOfSpur",
                  gear("teeth = 20\nmodule = 1\nhelix_deg = 10"),
                  {{5, 13, "spur gears have none"}}},
        FaultCase{"HelicalWithoutHelix",
                  gear("gearing = \"helical\"\nteeth = 20\nmodule = 1"),
                  {{2, 1, "helix_deg is missing"}}},
        FaultCase{"NoRoot",
                  gear("teeth = 3\nmodule = 1\nprofile_shift = -1"),
                  {{3, 9, "beyond the gear's centre"}}},
        FaultCase{"NoTooth",
                  gear("teeth = 20\nmodule = 1\ntip_reduction = 2\n[rack]\naddendum = 0.7"),
                  {{5, 17, "leaves no tooth"}}},
        FaultCase{"PointedRack",
                  gear("teeth = 20\nmodule = 1\n[rack]\naddendum = 3"),
                  {{5, 1, "flanks that meet before its tip"}}},
        FaultCase{"LargeTipRadius",
                  gear("teeth = 20\nmodule = 1\n[rack]\nclearance = 0.4\ntip_radius = 0.4"),
                  {{7, 14, "at most 0.39394"}}},
        FaultCase{"SmallHelix",
                  gear("gearing = \"helical\"\nteeth = 20\nmodule = 1\nhelix_deg = 1e-4"),
                  {{6, 13, "from 0.001 to 80"}}},
        FaultCase{"Unknown",
                  gear("teeth = 20\nmodule = 1\nmodul = 2"),
                  {{5, 1, "unknown key \"modul\""}}},
        FaultCase{"SpanOverTooManyTeeth",
                  gear("teeth = 20\nmodule = 1\n[output]\nspan_teeth = 9"),
                  {{6, 14, "allowed is a number from 1 to 4"}}},
        FaultCase{"Points",
                  gear("teeth = 20\nmodule = 1\n[output]\npoints = 0"),
                  {{6, 10, "from 1 to 10000"}}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Pairs, GearFaultTest,
    ::testing::Values(
        FaultCase{"NothingOfAPair",
                  "kind = \"gear-pair\"",
                  {{1, 1, "mechanism.teeth is missing"}, {1, 1, "mechanism.module is missing"}}},
        FaultCase{"OneNumberOfTeeth", pair("teeth = [20]\nmodule = 1"), {{3, 9, "[z1, z2]"}}},
        FaultCase{"TeethTwice",
                  pair(kWhole + "[bounds]\nteeth = [[10, 20], [30, 40]]"),
                  {{6, 9, "beside mechanism.teeth"}}},
        FaultCase{"EmptyTeeth",
                  pair("module = 1\n[bounds]\nteeth = [[20, 10], [30, 40]]"),
                  {{5, 9, "empty range"}}},
        FaultCase{"TooMany",
                  pair("module = 1\n[bounds]\nteeth = [[3, 2000], [3, 2000]]"),
                  {{5, 9, "combinations"}}},
        FaultCase{"OverDetermined",
                  pair(kWhole + "profile_shift = [0, 0]\ncentre_distance = 255\nbacklash = 0.1"),
                  {{7, 12, "from which it follows"}}},
        FaultCase{"ShiftOutside",
                  pair(kWhole + "profile_shift = [0, 0.9]\n[bounds]\nprofile_shift = [0, 0.5]"),
                  {{5, 17, "outside its bounds"}}},
        FaultCase{"SizeOfAGivenDistance",
                  pair(kWhole + "centre_distance = 255\n[target]\nobjective = \"size\""),
                  {{7, 13, "centre_distance fixes"}}},
        FaultCase{"ToleranceAlone",
                  pair(kWhole + "[target]\nratio_tolerance = 0.1"),
                  {{6, 19, "expected ratio"}}},
        FaultCase{"ContactRatioBelowOne",
                  pair(kWhole + "[constraints]\ncontact_ratio_min = 0.9"),
                  {{6, 21, "from 1 to 100"}}},
        FaultCase{"WormKeysOfSpur",
                  pair(kWhole + "starts = 1\nfriction = 0.1"),
                  {{5, 10, "spur gears have none"}, {6, 12, "spur gears have none"}}},
        FaultCase{"BevelShifts",
                  pair("gearing = \"bevel\"\n" + kWhole + "profile_shift = [0.1, 0.2]"),
                  {{6, 17, "[x, -x]"}}},
        FaultCase{"BevelSearched",
                  pair("gearing = \"bevel\"\nmodule = 2\n[bounds]\nteeth = [[10, 20], [20, 30]]"),
                  {{2, 1, "mechanism.teeth is missing"}, {5, 1, "not searched for"}}},
        FaultCase{"WormWithTeeth",
                  pair("gearing = \"worm\"\nwheel_teeth = 40\n" + kWhole),
                  {{5, 9, "wheel_teeth"}}},
        FaultCase{"WormWithADistance",
                  pair("gearing = \"worm\"\nwheel_teeth = 40\nmodule = 2\ncentre_distance = 60"),
                  {{6, 19, "follows from module, diameter_quotient, wheel_teeth"}}},
        FaultCase{"WormWithShifts",
                  pair("gearing = \"worm\"\nwheel_teeth = 40\nmodule = 2\nprofile_shift = [0, 0]"),
                  {{6, 17, "by wheel_shift"}}},
        FaultCase{"FreeHelixWithoutShifts",
                  pair("gearing = \"helical\"\n" + kWhole +
                       "centre_distance = 260\nhelix_deg = \"free\""),
                  {{7, 13, "without profile_shift; expected values of teeth, module"}}},
        FaultCase{"FreeHelixOfACloseDistance",
                  pair("gearing = \"helical\"\n" + kWhole +
                       "centre_distance = 250\nhelix_deg = \"free\"\nprofile_shift = [0, 0]"),
                  {{6, 19, "expected more than 250"}}},
        FaultCase{"FreeHelixOfThinTeeth",
                  pair("gearing = \"helical\"\nteeth = [10, 11]\nmodule = 1\n"
                       "centre_distance = 11\nhelix_deg = \"free\"\nprofile_shift = [-5, -5]"),
                  {{8, 17, "expected greater shifts"}}},
        FaultCase{"FreeHelixOfSpur",
                  pair(kWhole + "helix_deg = \"free\""),
                  {{5, 13, "spur gears have none"}}},
        FaultCase{"UnknownOfSpur",
                  pair(kWhole + "helix = 1"),
                  {{5, 1, "\"gearing\", \"face_width\", \"teeth\""}}},
        FaultCase{"WormWithContactRatio",
                  pair("gearing = \"worm\"\nwheel_teeth = 40\nmodule = 2\n[constraints]\n"
                       "contact_ratio_min = 1.2"),
                  {{7, 21, "it is not known"}}},
        FaultCase{"UnknownGearing",
                  pair("gearing = \"spiral\"\n" + kWhole + "[bounds]\nmodules = [1]"),
                  {{3, 11, "allowed are"}}},
        FaultCase{"ShiftWord", pair(kWhole + "profile_shift = [0, \"fre\"]"), {{5, 21, "number"}}}),
    name_of_case);

}  // namespace
}  // namespace cognate::problems::gear_problem_test
