/// Gear trains from their files: values, defaults, and every fault at its place.
#include <gtest/gtest.h>

#include <string>

#include "problems/read.hpp"
#include "problems/train/result.hpp"
#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::gear_train_problem_test {
namespace {

const std::string kKind = "kind = \"gear-train\"\n";

// One line each: kKind is line 1, the meshes are lines 2 and 3, planets line 4.
const std::string kSet =
    kKind +
    "mesh = [{gears = [\"sun\", \"planet\"], teeth = [24, 30]},\n"
    "{gears = [\"planet\", \"ring\"], teeth = [30, 84], type = \"internal\"}]\n"
    "planet = [{name = \"planet\", carrier = \"arm\", count = 3}]\n";
const std::string kInput = "input = [{member = \"sun\"}]\n";
const std::string kFixed = "mechanism.fixed = [\"ring\"]\n";

TEST(GearTrainProblemTest, ASetAndItsDefaults) {
  const auto read = parse_task<GearTrainProblem>(kSet + kInput + kFixed);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->meshes[1].type, MeshType::internal);
  EXPECT_EQ(read->meshes[0].efficiency, 1);
  EXPECT_EQ(read->inputs[0].speed, 1);
  EXPECT_FALSE(read->output);
  EXPECT_FALSE(read->target);
  EXPECT_TRUE(KindTraits<GearTrainProblem>::checked(*read));
}

TEST(GearTrainProblemTest, ATargetAndItsDefaults) {
  const auto read = parse_task<GearTrainProblem>(kKind + "[target]\nratio = \"355/113\"");
  ASSERT_TRUE(read);
  EXPECT_DOUBLE_EQ(read->target->ratio, 355.0 / 113);
  EXPECT_EQ(read->target->pairs, (std::array{1, 3}));
  EXPECT_EQ(read->target->designs, 3);
  EXPECT_TRUE(KindTraits<GearTrainProblem>::checked(*read));
}

class GearTrainFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(GearTrainFaults, AreAllFoundAtTheirPlaces) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Files, GearTrainFaults,
    ::testing::Values(
        FaultCase{"Nothing", kKind, {{1, 1, "mesh is missing"}}},
        FaultCase{"NoMesh", kKind + "mesh = []", {{2, 8, "mesh"}}},
        FaultCase{"ZeroTeeth",
                  kKind + "mesh = [{gears = [\"a\", \"b\"], teeth = [0, 30]}]\n" + kInput,
                  {{2, 39, "from 3 to 10000"}}},
        FaultCase{"NegativeTeeth",
                  kKind + "mesh = [{gears = [\"a\", \"b\"], teeth = [20, -30]}]\n" + kInput,
                  {{2, 43, "from 3 to 10000"}}},
        FaultCase{"HugeTeeth",
                  kKind + "mesh = [{gears = [\"a\", \"b\"], teeth = [1e300, 30]}]\n" + kInput,
                  {{2, 39, "from 3 to 10000"}}},
        FaultCase{"MeshWithItself",
                  kKind + "mesh = [{gears = [\"a\", \"a\"], teeth = [20, 30]}]\n" + kInput,
                  {{2, 18, "one member twice"}}},
        FaultCase{"EqualInternal",
                  kKind +
                      "mesh = [{gears = [\"a\", \"b\"], teeth = [30, 30], type = \"internal\"}]\n" +
                      kInput,
                  {{2, 38, "expected more"}}},
        FaultCase{"UnknownMember",
                  kSet + kFixed + "input = [{member = \"sum\"}]",
                  {{6, 20, "perhaps for \"sun\""}}},
        FaultCase{"PlanetAsInput",
                  kSet + kFixed + "input = [{member = \"planet\"}]",
                  {{6, 20, "a planet"}}},
        FaultCase{"NoInput", kSet + kFixed, {{1, 1, "input is missing"}}},
        FaultCase{"TooFree", kSet + kInput, {{5, 9, "2 degrees of freedom and 1 input"}}},
        FaultCase{"TooManyInputs",
                  kSet + kFixed + "input = [{member = \"sun\"}, {member = \"arm\"}]",
                  {{6, 38, "follows from the other inputs"}}},
        FaultCase{"Locked",
                  kSet + "mechanism.fixed = [\"ring\", \"arm\"]\n" + kInput,
                  {{6, 20, "cannot turn"}}},
        FaultCase{"LoopThatLocks",
                  kKind + "mesh = [{gears = [\"a\", \"b\"], teeth = [20, 30]},\n"
                          "{gears = [\"a\", \"b\"], teeth = [21, 30]}]\ninput = [{member = \"a\"}]",
                  {{4, 20, "cannot turn"}}},
        FaultCase{"Apart",
                  kKind + "mesh = [{gears = [\"a\", \"b\"], teeth = [20, 30]},\n"
                          "{gears = [\"c\", \"d\"], teeth = [21, 30]}]\ninput = [{member = \"a\"}]",
                  {{4, 9, "\"c\"'s speed is not determined"}}},
        FaultCase{"StateTooFree",
                  kSet + kInput + "state = [{name = \"neutral\"}]",
                  {{6, 18, "where \"arm\"'s speed is not determined"}}},
        FaultCase{"UnknownBrake",
                  kSet + kInput + kFixed + "state = [{name = \"1\", engaged = [\"B1\"]}]",
                  {{7, 33, "no brake and no clutch"}}},
        FaultCase{"MassWithoutModule",
                  kKind + "mesh = [{gears = [\"sun\", \"planet\"], teeth = [24, 30]}]\n"
                          "planet = [{name = \"planet\", carrier = \"arm\", mass = 2}]\n"
                          "mechanism.fixed = [\"sun\"]\ninput = [{member = \"arm\"}]",
                  {{3, 53, "expected module"}}},
        FaultCase{"TargetBesideMesh",
                  kSet + "target.ratio = 3",
                  {{2, 8, "beside target"}, {4, 10, "beside target"}}},
        FaultCase{"EmptyTeeth",
                  kKind + "[target]\nratio = 3\n[bounds]\nteeth = [40, 20]",
                  {{5, 9, "bounds.teeth"}}},
        FaultCase{"TooManyTeeth",
                  kKind + "[target]\nratio = 3\n[bounds]\nteeth = [3, 10000]",
                  {{5, 9, "narrower range"}}},
        FaultCase{"ZeroRatio", kKind + "[target]\nratio = 0", {{3, 9, "of magnitude"}}},
        FaultCase{"OneMemberTwice",
                  kKind + "[target]\ntrain = \"planetary\"\nratio = 3\noutput = \"sun\"",
                  {{5, 10, "two different members"}}}),
    name_of_case);

}  // namespace
}  // namespace cognate::problems::gear_train_problem_test
