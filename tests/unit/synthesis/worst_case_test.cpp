/// The exact worst case over a box against a dense search in 113 bits, which shares no formula.
#include "synthesis/tolerance/worst_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/tolerance/sensitivity.hpp"
#include "tests/support/toleranced_four_bars.hpp"

namespace cognate::synthesis::worst_case_test {
namespace {

using test::Quad;
using test::QuadDimensions;
using test::TolerancedFourBar;

Response rocker() {
  Response response;
  response.type = ResponseType::angle;
  response.index = 3;
  return response;
}

TEST(WorstCase, PartialsAreThoseOf113BitsOnRandomFourBars) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const TolerancedFourBar linkage(random);
    const std::vector responses{rocker()};
    const std::vector stations{linkage.station()};
    const auto table = sensitivities(linkage.mechanism(), responses, stations);
    for (int i = 0; i < 4; ++i) {
      const double rate = table.rates(0, 0)[static_cast<std::size_t>(i)].x;
      const auto exact = static_cast<double>(
          test::quad_rocker_rate(linkage.quad(), i, linkage.angle(), linkage.side()));
      EXPECT_NEAR(rate, exact, 1e-9 * std::max(1.0, std::abs(exact))) << trial << ' ' << i;
    }
  }
}

TEST(WorstCase, NoPointOfADenseSearchIsOutside) {
  std::mt19937_64 random(12);
  int determined = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const TolerancedFourBar linkage(random);
    const auto searched = test::dense_extremes(linkage, random, 400);
    const auto worst = worst_case(linkage.mechanism(), rocker(), linkage.station(), linkage.box());
    if (!worst) continue;
    ++determined;
    ASSERT_TRUE(searched) << "bounded where samples cannot be assembled, trial " << trial;
    EXPECT_GE(worst->high, searched->high - 1e-12) << trial;
    EXPECT_LE(worst->low, searched->low + 1e-12) << trial;
    // And the bounds are reached: corners and the interior between them come within a thousandth.
    EXPECT_LE(worst->high, searched->high + 1e-3 * std::abs(searched->high) + 1e-9) << trial;
    EXPECT_GE(worst->low, searched->low - 1e-3 * std::abs(searched->low) - 1e-9) << trial;
  }
  EXPECT_GT(determined, 40);
}

TEST(WorstCase, ABoxThatReachesADeadPointHasNone) {
  const TolerancedFourBar linkage({1, 3, 2, Quad("3.99"), 0, 0}, 178 * kPi / 180, 1, 0.01);
  EXPECT_FALSE(worst_case(linkage.mechanism(), rocker(), linkage.station(), linkage.box()));
}

// The farthest corner of a zonotope against all its corners.
TEST(WorstCase, TheFarthestCornerIsTheFarthestOfAll) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec2d> arms(1 + trial % 9);
    for (Vec2d& arm : arms) arm = {unit(random), trial % 4 == 0 ? 0.0 : unit(random)};
    double most = 0;
    for (int corner = 0; corner < (1 << arms.size()); ++corner) {
      Vec2d at{};
      for (std::size_t i = 0; i < arms.size(); ++i) {
        at = at + ((corner >> i) % 2 == 1 ? 1.0 : -1.0) * arms[i];
      }
      most = std::max(most, norm(at));
    }
    EXPECT_NEAR(farthest_corner(arms), most, 1e-13);
  }
}

}  // namespace
}  // namespace cognate::synthesis::worst_case_test
