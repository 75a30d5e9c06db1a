// The layers of random six-bars and of the mechanisms of the library against brute force.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/layers/assign.hpp"
#include "problems/read.hpp"
#include "tests/stress/layers_brute.hpp"
#include "tests/stress/layers_cases.hpp"
#include "tests/support/folders.hpp"

namespace cognate::test {
namespace {

TEST(Layers, OfRandomSixBarsAreTheFewest) {
  std::mt19937 random(5);
  LayerCounts counts;
  for (int i = 0; i < 60; ++i) {
    const LayerCase given = random_six_bar(random);
    EXPECT_EQ(fault_of_layers(given, 720, true, counts), "") << i;
  }
  EXPECT_GT(counts.assigned, 20);
  EXPECT_GT(counts.impossible, 5);
}

class LibraryLayers : public testing::TestWithParam<const char*> {};

TEST_P(LibraryLayers, AreTheFewest) {
  const auto problem = problems::read_task<problems::AnalysisProblem>(
      std::filesystem::path(kLibraryFolder) / "analysis" / GetParam());
  ASSERT_TRUE(problem) << problem.error().front().message;
  const auto& mechanism = problem->mechanism;
  const AssemblyRanges motion = follow(mechanism.mechanism, 0, kTurn);
  ASSERT_EQ(motion.runs.size(), 1u);
  const AssemblyRange& run = motion.runs.front();
  const double crank = std::get<Crank<double>>(mechanism.mechanism.drive).length;
  for (const double width : {0.05, 0.2, 0.4}) {
    problems::LayerSizes sizes{width * crank, 0.6 * width * crank, 0.02 * crank, {}};
    const auto layers = problems::assign_layers(mechanism, motion, sizes);
    ASSERT_TRUE(layers);
    const BruteLayers brute(mechanism, sizes, run.from, run.to, 720);
    EXPECT_EQ(layers->count, brute.fewest()) << width;
    if (layers->count) {
      EXPECT_LT(brute.interference(*layers), 0) << width;
    }
    for (const auto& conflict : layers->conflicts) {
      EXPECT_TRUE(brute.confirms(conflict, 1e-5 * crank)) << conflict.first << conflict.second;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Library, LibraryLayers,
                         testing::Values("crank-rocker.toml", "watt-six-bar.toml",
                                         "stephenson-six-bar.toml", "shaper.toml",
                                         "toggle-press.toml", "klann-leg.toml", "jansen-leg.toml"));

}  // namespace
}  // namespace cognate::test
