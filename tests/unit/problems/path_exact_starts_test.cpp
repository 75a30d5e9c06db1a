/// Exact synthesis through nine of many points gives a path search the linkage that drew them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/path/exact/starts.hpp"
#include "tests/support/planted_path.hpp"

namespace cognate::problems::path_exact_starts_test {
namespace {

double difference(const FourBar& a, const FourBar& b) {
  return std::max({norm(a.pivot_a - b.pivot_a), norm(a.pivot_d - b.pivot_d),
                   std::abs(a.crank - b.crank), std::abs(a.coupler - b.coupler),
                   std::abs(a.rocker - b.rocker), norm(*a.coupler_point - *b.coupler_point)});
}

PathProblem planted_problem(const test::PlantedPath& planted) {
  PathProblem problem;
  for (const auto& position : test::positions_of(planted, 0)) {
    problem.points.push_back(position.at);
  }
  return problem;
}

TEST(ExactStarts, HoldThePlantedLinkage) {
  std::mt19937_64 random(11);
  const auto planted = test::random_crank_rocker(random, 13, 1.0);
  const PathProblem problem = planted_problem(planted);
  ASSERT_TRUE(has_exact_starts(problem));
  const problems::Run run;
  const auto starts = exact_starts(problem, run, Deadline(run));
  ASSERT_FALSE(starts.empty());
  const PathStart& nearest = *std::ranges::min_element(starts, {}, [&](const PathStart& start) {
    return difference(start.linkage, planted.linkage);
  });
  EXPECT_LT(difference(nearest.linkage, planted.linkage), 1e-6);
  ASSERT_EQ(nearest.crank_angles.size(), 13u);
  for (std::size_t j = 0; j < 13; ++j) {
    const double off = nearest.crank_angles[j] - planted.crank_angles[j];
    EXPECT_LT(std::abs(std::remainder(off, kTurn)), 0.4);
  }
}

TEST(ExactStarts, AreForPathsThatNothingLimits) {
  std::mt19937_64 random(12);
  PathProblem problem = planted_problem(test::random_crank_rocker(random, 9, 1.0));
  EXPECT_TRUE(has_exact_starts(problem));
  PathProblem other = problem;
  other.points.pop_back();
  EXPECT_FALSE(has_exact_starts(other));
  other = problem;
  other.points[8] = other.points[2];
  EXPECT_FALSE(has_exact_starts(other));
  other = problem;
  other.given.crank = 1;
  EXPECT_FALSE(has_exact_starts(other));
  other = problem;
  other.bounds.rocker = Range{0, 9};
  EXPECT_FALSE(has_exact_starts(other));
}

}  // namespace
}  // namespace cognate::problems::path_exact_starts_test
