// Progress of runs that have several parts: no share is taken back, and no part goes beyond its
// end.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "problems/cam/result.hpp"
#include "problems/gear/result.hpp"
#include "problems/kinds.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::run_progress_test {
namespace {

/// Runs a problem of the library and checks what it reports as it does; the parts that it names. On
/// one thread, which reports.
template <class Problem>
std::vector<Phase> parts_of(const char* file, double time_limit = 20) {
  const auto problem = read_task<Problem>(std::filesystem::path(kLibraryFolder) / file);
  EXPECT_TRUE(problem) << file;
  std::vector<Phase> parts;
  double done = 0, end = 1;
  Run run{.threads = 1, .time_limit = time_limit};
  run.progress = [&](double share, double) {
    EXPECT_GE(share, done) << file << " falls back";
    EXPECT_FALSE(share > end + 1e-9) << file << " goes on to " << share << " beyond " << end;
    done = share;
  };
  run.phase = [&](Phase part, double to) {
    EXPECT_FALSE(to < done) << file << " has come to " << done;
    parts.push_back(part);
    end = std::isfinite(to) ? to : 1;
  };
  solve(*problem, run);
  EXPECT_GT(done, 0) << file;
  return parts;
}

using Parts = std::vector<Phase>;

TEST(RunProgress, OfARasterComesAfterThatOfTheSearchBetweenItsValues) {
  const Parts both{Phase::search, Phase::raster};
  EXPECT_EQ(parts_of<PathProblem>("path/ellipse-on-half-units.toml"), both);
  const Parts cam = parts_of<CamProblem>("cam/oscillating-roller-on-raster.toml");
  EXPECT_EQ(cam.back(), Phase::raster);
}

TEST(RunProgress, OfARobustDesignComesAfterThatOfTheNominalOne) {
  const Parts parts = parts_of<PathProblem>("path/ellipse-robust.toml", 4);
  ASSERT_GE(parts.size(), 2U);
  EXPECT_EQ((Parts{parts[0], parts[1]}), (Parts{Phase::search, Phase::robustness}));
}

TEST(RunProgress, OfSeveralSearchesOfGearsIsOne) {
  const Parts parts = parts_of<GearPairProblem>("gear-pair/enumerated-teeth.toml");
  EXPECT_GE(parts.size(), 1U);
}

}  // namespace
}  // namespace cognate::problems::run_progress_test
