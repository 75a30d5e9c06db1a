/// Proofs over boxes with four unknowns against single designs in them, evaluated on another way.
#include "synthesis/lanes/path_proof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "tests/support/planted_proofs.hpp"

namespace cognate::synthesis::path_proof_test {
namespace {

using test::PlantedProof;

int repeats(int usual) {
  const char* asked = std::getenv("COGNATE_TEST_SEEDS");
  return asked ? std::max(1, std::min(usual, 40 * std::atoi(asked))) : usual;
}

int verdict(const PathProver& prover, const ProportionBox& box, double target) {
  StageVerdict verdict;
  prover.judge({&box, 1}, target, target, {&verdict, 1});
  return verdict.reached;
}

// Boxes of many widths, a fifth of the designs at change points, targets just above their errors.
TEST(PathProof, NeverDiscardsAPlantedDesign) {
  std::mt19937_64 random(1);
  int below = 0, boxes = 0;
  for (int i = 0; i < repeats(1500); ++i) {
    const auto planted = test::planted_proof(random);
    if (!planted) continue;
    const PathProver prover(planted->path, test::no_limits());
    for (int n = 0; n < 8; ++n) {
      const ProportionBox box =
          test::box_with(planted->at, planted->assembly, planted->proportions, random);
      ++boxes;
      ASSERT_EQ(verdict(prover, box, planted->error * (1 + 1e-7) + 1e-13), 0) << i << ' ' << n;
      below += verdict(prover, box, 0.5 * planted->error) > 0;
    }
  }
  EXPECT_GT(boxes, repeats(1500) * 6);
  EXPECT_GT(below, boxes / 10);  // else the test would say nothing
}

/// Boxes of all widths with a path that some of them reach.
struct Sample {
  PlantedProof planted;
  std::vector<ProportionBox> boxes;
};
Sample sample(int count) {
  std::mt19937_64 random(2);
  auto planted = test::planted_proof(random);
  while (!planted) planted = test::planted_proof(random);
  Sample result{*planted, {}};
  for (int i = 0; i < count; ++i) {
    result.boxes.push_back(test::box_with(result.planted.at, result.planted.assembly,
                                          result.planted.proportions, random));
    // Moved off the design, so that many boxes are proved.
    for (Interval& side : result.boxes.back().side) {
      const double shift = 0.2 * (side.high - side.low);
      side = {side.low + shift, side.high};
    }
  }
  return result;
}

TEST(PathProof, IsTheSameInAnyLane) {
  const Sample given = sample(301);
  const double target = 1.2 * given.planted.error;
  std::vector<StageVerdict> whole(given.boxes.size());
  const PathProver prover(given.planted.path, test::no_limits());
  prover.judge(given.boxes, target, 0.5 * target, whole);
  int kinds[3] = {};
  for (std::size_t i = 0; i < given.boxes.size(); ++i) {
    StageVerdict alone;
    prover.judge({&given.boxes[i], 1}, target, 0.5 * target, {&alone, 1});
    EXPECT_EQ(alone.reached, whole[i].reached) << i;
    EXPECT_EQ(alone.side, whole[i].side) << i;
    ++kinds[alone.reached];
  }
  EXPECT_GT(kinds[0], 3);
  EXPECT_GT(kinds[1] + kinds[2], 3);
}

TEST(PathProof, IsTheSameWithAnyInstructions) {
  const Sample given = sample(300);
  const double target = 1.2 * given.planted.error;
  std::vector<StageVerdict> widest(given.boxes.size()), other(given.boxes.size());
  PathProver(given.planted.path, test::no_limits()).judge(given.boxes, target, 0, widest);
  for (const InstructionSet set : instruction_sets()) {
    PathProver(given.planted.path, test::no_limits(), set).judge(given.boxes, target, 0, other);
    for (std::size_t i = 0; i < given.boxes.size(); ++i) {
      EXPECT_EQ(other[i].reached, widest[i].reached) << name(set) << ' ' << i;
    }
  }
}

ProportionBox about(const PlantedProof& planted, double half) {
  ProportionBox box;
  box.proportions = planted.proportions;
  box.assembly = planted.assembly;
  const auto [low, high] = test::side_limits(planted.proportions);
  for (int i = 0; i < kBoxSides; ++i) {
    box.side[i] = {std::max(low[i], planted.at[i] - half), std::min(high[i], planted.at[i] + half)};
  }
  return box;
}

BranchResult search(const PlantedProof& planted, double half, std::vector<double> targets,
                    int threads) {
  const PathProver prover(planted.path, test::no_limits());
  StageOptions options;
  options.targets = std::move(targets);
  options.threads = threads;
  return staged_search(
      std::vector{about(planted, half)}, options,
      [&](std::span<const ProportionBox> boxes, double target, double first,
          std::span<StageVerdict> verdicts) { prover.judge(boxes, target, first, verdicts); },
      halves);
}

// A planted design is no minimum, so a target below its error may or may not be proved; one above
// it never.
TEST(StagedSearch, ProvesNothingAboveAKnownError) {
  std::mt19937_64 random(3);
  int staged = 0;
  for (int i = 0; i < repeats(12); ++i) {
    const auto planted = test::planted_proof(random);
    if (!planted || planted->error < 1e-6) continue;
    const double error = planted->error * 1.001;
    const BranchResult result = search(*planted, 1e-3, {0.1 * error, 0.9 * error, error}, 2);
    EXPECT_FALSE(result.complete) << i;
    EXPECT_EQ(search(*planted, 1e-3, {0.1 * error, 0.9 * error, error}, 1).boxes, result.boxes);
    EXPECT_LT(result.lower, planted->error) << i;
    staged += result.lower > 0;
  }
  if (repeats(12) == 12) {
    EXPECT_GT(staged, 0);
  }
}

TEST(StagedSearch, DoesNotDependOnThreads) {
  std::mt19937_64 random(4);
  int complete = 0;
  for (int i = 0; i < repeats(8); ++i) {
    const auto planted = test::planted_proof(random);
    if (!planted) continue;
    const std::vector<double> targets{0.05 * planted->error, 0.1 * planted->error};
    const BranchResult one = search(*planted, 0.05, targets, 1);
    const BranchResult many = search(*planted, 0.05, targets, 5);
    EXPECT_EQ(one.boxes, many.boxes) << i;
    EXPECT_EQ(one.lower, many.lower) << i;
    complete += one.complete;
  }
  if (repeats(8) == 8) {
    EXPECT_GT(complete, 0);
  }
}

// The stages examine the boxes of the last target and no more.
TEST(StagedSearch, StagesCostNoBoxes) {
  std::mt19937_64 random(5);
  const auto planted = test::planted_proof(random);
  ASSERT_TRUE(planted);
  const double last = 0.2 * planted->error;
  const BranchResult whole = search(*planted, 0.02, {last}, 1);
  const BranchResult staged = search(*planted, 0.02, {0.1 * last, 0.5 * last, last}, 1);
  EXPECT_EQ(whole.complete, staged.complete);
  ASSERT_TRUE(whole.complete);
  EXPECT_EQ(whole.boxes, staged.boxes);
}

TEST(StagedSearch, EndsWhenStopped) {
  std::mt19937_64 random(6);
  const auto planted = test::planted_proof(random);
  ASSERT_TRUE(planted);
  const PathProver prover(planted->path, test::no_limits());
  StageOptions options;
  options.targets = {planted->error};
  options.stop = [] { return true; };
  const BranchResult result = staged_search(
      std::vector{about(*planted, 0.5)}, options,
      [&](std::span<const ProportionBox> boxes, double target, double first,
          std::span<StageVerdict> verdicts) { prover.judge(boxes, target, first, verdicts); },
      halves);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.lower, 0);
}

}  // namespace
}  // namespace cognate::synthesis::path_proof_test
