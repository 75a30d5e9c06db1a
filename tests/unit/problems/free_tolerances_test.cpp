/// Tolerances of least cost where some dimensions do not change the error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "problems/evaluation/result.hpp"
#include "problems/read.hpp"

namespace cognate::problems::free_tolerances_test {
namespace {

ToleranceResult rocker(const std::string& tolerance) {
  const auto read = parse_task<AnalysisProblem>(
      "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\n"
      "fixed_pivots = [[0, 0], [110, 0]]\ncrank = 40\ncoupler = 120\nrocker = 80\n"
      "coupler_point = [60, 10]\n[drive]\nsteps = 12\n[tolerance]\nsamples = 0\n" +
      tolerance + "\n");
  if (!read) {
    ADD_FAILURE() << read.error().front().message;
    return {};
  }
  return analyse(*read, {.threads = 1}).tolerance.value_or(ToleranceResult{});
}

double allocated(const ToleranceResult& result, const std::string& dimension) {
  const auto found =
      std::ranges::find(result.allocation, dimension, &AllocatedTolerance::dimension);
  return found == result.allocation.end() ? NAN : found->tolerance;
}

bool notes(const ToleranceResult& result, const std::string& part) {
  return std::ranges::any_of(
      result.notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

// The coupler point moves no rocker: the lengths share the limit as if it had no tolerance.
TEST(FreeTolerances, ADimensionWithoutInfluenceTakesNothingFromTheOthers) {
  for (const std::string by : {"worst-case", "rss"}) {
    const std::string allocate =
        "allocate = {limit_deg = 0.3, by = \"" + by + "\"}\nlength = 0.1\n";
    const auto with = rocker(allocate + "coupler_point = 0.1");
    const auto without = rocker(allocate + "coupler_point = 0");
    EXPECT_TRUE(std::isinf(allocated(with, "coupler_point.u")));
    EXPECT_TRUE(notes(with, "does not change with coupler_point.u, coupler_point.v"));
    EXPECT_FALSE(notes(without, "does not change"));
    ASSERT_EQ(without.allocation.size(), 4U);
    for (const auto& [name, tolerance, cost] : without.allocation) {
      EXPECT_NEAR(allocated(with, name), tolerance, 1e-12 * tolerance) << name;
      EXPECT_NEAR(cost, 1 / tolerance, 1e-12 * cost);
    }
    EXPECT_NEAR(*with.allocation_cost, *without.allocation_cost, 1e-12 * *with.allocation_cost);
  }
}

TEST(FreeTolerances, WhereNothingHasInfluenceNothingIsAllocated) {
  const auto result = rocker("coupler_point = 0.1\nallocate = {limit_deg = 0.3}");
  EXPECT_TRUE(result.allocation.empty());
  EXPECT_FALSE(result.allocation_cost);
  EXPECT_TRUE(notes(result, "no dimension changes the error"));
}

}  // namespace
}  // namespace cognate::problems::free_tolerances_test
