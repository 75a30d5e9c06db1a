// No box that holds a better linkage is discarded by the proofs of worked problems.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "problems/read.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/proof_descents.hpp"

namespace cognate::problems::proof_soundness_test {
namespace {

PathProblem of_library(const std::string& name) {
  return read_task<PathProblem>(std::filesystem::path(kLibraryFolder) / "path" / name).value();
}

void expect_sound(const PathProblem& problem, long boxes, int seed) {
  std::mt19937_64 random(seed);
  const test::DescentTally tally = test::descend(problem, boxes, random);
  EXPECT_EQ(tally.wrongly_discarded, 0);
  EXPECT_GE(tally.boxes, boxes);
  EXPECT_GT(tally.designs, boxes / 100);
  // A proof that discards nothing would pass.
  EXPECT_GT(tally.discarded_below, boxes / 20);
}

TEST(ProofSoundness, OfEighteenPoints) {
  expect_sound(of_library("eighteen-points.toml"), 4000, 1);
}

TEST(ProofSoundness, OfEightPointsInBothSenses) {
  expect_sound(of_library("textbook-eight-points.toml"), 4000, 2);
}

TEST(ProofSoundness, OfASemicircleWithinLengths) {
  expect_sound(of_library("semicircle.toml"), 4000, 3);
}

TEST(ProofSoundness, OfAnArcAboutAGivenPivot) {
  expect_sound(of_library("five-point-arc.toml"), 4000, 4);
}

TEST(ProofSoundness, OfAnArcByAnyClass) {
  PathProblem problem = of_library("five-point-arc.toml");
  problem.constraints.required_class.reset();
  expect_sound(problem, 4000, 5);
}

// The test itself: bounds a fiftieth too high discard boxes that hold better linkages.
TEST(ProofSoundness, SeesABoundThatIsTooHigh) {
  std::mt19937_64 random(6);
  const auto tally = test::descend(of_library("textbook-eight-points.toml"), 4000, random, 1.02);
  EXPECT_GT(tally.wrongly_discarded, 0);
}

}  // namespace
}  // namespace cognate::problems::proof_soundness_test
