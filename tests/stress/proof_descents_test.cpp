// Over a million boxes of the proofs of worked problems, each with a linkage in it that is better
// than the bound: none is discarded.
#include "tests/support/proof_descents.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::proof_descents_test {
namespace {

struct Case {
  const char* name;
  const char* file;
  bool any_class = false;
};

class ProofDescents : public ::testing::TestWithParam<Case> {};

TEST_P(ProofDescents, NeverDiscardABetterLinkage) {
  constexpr long kBoxes = 250'000;
  auto problem =
      read_task<PathProblem>(std::filesystem::path(kLibraryFolder) / "path" / GetParam().file)
          .value();
  if (GetParam().any_class) problem.constraints.required_class.reset();
  std::mt19937_64 random(11);
  const test::DescentTally tally = test::descend(problem, kBoxes, random);
  EXPECT_EQ(tally.wrongly_discarded, 0);
  EXPECT_GE(tally.boxes, kBoxes);
  EXPECT_GT(tally.designs, kBoxes / 100);
  EXPECT_GT(tally.discarded_below, kBoxes / 20);
  EXPECT_GT(tally.deepest, 30);
}

INSTANTIATE_TEST_SUITE_P(Of, ProofDescents,
                         ::testing::Values(Case{"EighteenPoints", "eighteen-points.toml"},
                                           Case{"EightPoints", "textbook-eight-points.toml"},
                                           Case{"Semicircle", "semicircle.toml"},
                                           Case{"Arc", "five-point-arc.toml"},
                                           Case{"ArcByAnyClass", "five-point-arc.toml", true}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace cognate::problems::proof_descents_test
