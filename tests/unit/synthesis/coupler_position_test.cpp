/// The range of the crank about a position, against dimensions whose limits are known.
#include "synthesis/exact/straight_line/coupler_position.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis::coupler_position_test {
namespace {

FourBar four_bar(double crank, double coupler, double rocker, double frame) {
  return {.pivot_a = {0, 0},
          .pivot_d = {frame, 0},
          .crank = crank,
          .coupler = coupler,
          .rocker = rocker,
          .assembly = Assembly::open};
}

void expect_range(const CouplerLinkage& linkage, double crank_angle, double from, double to) {
  const auto range = range_about(linkage, crank_angle);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->from, from, 1e-12);
  EXPECT_NEAR(range->to, to, 1e-12);
}

TEST(RangeAbout, EndsAtTheChangePointsOfAParallelogram) {
  const FourBar linkage = four_bar(3, 5, 3, 5);
  expect_range(linkage, kTurn / 4, 0, kTurn / 2);
  expect_range(linkage, 3 * kTurn / 4, kTurn / 2, kTurn);
  expect_range(linkage, 5 * kTurn / 4, kTurn, 3 * kTurn / 2);
}

TEST(RangeAbout, IsATurnBetweenTheOneChangePointOfAKite) {
  expect_range(four_bar(3, 5, 5, 3), 1, 0, kTurn);
  expect_range(four_bar(3, 5, 5, 3), -1, -kTurn, 0);
}

TEST(RangeAbout, HasATurnToEitherSideWhereNothingEndsIt) {
  expect_range(four_bar(2, 5, 5, 6), 1, 1 - kTurn, 1 + kTurn);
}

/// The crank stops where coupler and rocker are in line: a triangle with sides 4, 5, 5 + 1.
TEST(RangeAbout, EndsWhereTheLinkageNoLongerCloses) {
  const double limit = std::acos((4 * 4 + 5 * 5 - 6 * 6) / (2 * 4 * 5.0));
  const FourBar linkage = four_bar(4, 5, 1, 5);
  const double folded = std::acos((4 * 4 + 5 * 5 - 4 * 4) / (2 * 4 * 5.0));
  expect_range(linkage, 0.5 * (folded + limit), folded, limit);
  expect_range(linkage, 0.5 * (folded + limit) + kTurn, folded + kTurn, limit + kTurn);
  EXPECT_FALSE(range_about(linkage, kTurn / 2));
}

}  // namespace
}  // namespace cognate::synthesis::coupler_position_test
