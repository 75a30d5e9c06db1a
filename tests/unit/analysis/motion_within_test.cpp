/// Whether a crank makes a motion, against the triangle inequality at many of its angles.
#include "analysis/linkage/motion_within.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/numbers/constants.hpp"

namespace cognate::motion_within_test {
namespace {

/// The least room that the triangle B–C–D has over the motion, in units of d²/(2 l₁ l₄).
double least_room(const Lengths<double>& links, const CrankRange& motion) {
  const auto [l1, l2, l3, l4] = links;
  double least = HUGE_VAL;
  const auto look = [&](double angle) {
    const double d2 = l1 * l1 + l4 * l4 - 2 * l1 * l4 * std::cos(angle);
    const double room = std::min((l2 + l3) * (l2 + l3) - d2, d2 - (l2 - l3) * (l2 - l3));
    least = std::min(least, room / (2 * l1 * l4));
  };
  for (int i = 0; i <= 200; ++i) look(motion.from + (motion.to - motion.from) * i / 200);
  for (double k = std::ceil(motion.from / kPi); k * kPi < motion.to; ++k) look(k * kPi);
  return least;
}

TEST(MotionWithin, AgreesWithTheTriangleOfRandomLinkages) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> length(0.2, 3), start(-12, 12), sweep(0, kTurn);
  int made = 0, not_made = 0, across_gaps = 0;
  for (int i = 0; i < 20000; ++i) {
    const Lengths<double> links{length(random), length(random), length(random), length(random)};
    const double from = start(random);
    const CrankRange motion{from, from + sweep(random)};
    const double room = least_room(links, motion);
    if (std::abs(room) < 1e-6) continue;
    const auto own = motion_within(crank_ranges(links), motion);
    ASSERT_EQ(own.has_value(), room > 0) << i;
    const CrankRange ends[] = {{motion.from, motion.from}, {motion.to, motion.to}};
    const bool ends_close = least_room(links, ends[0]) > 0 && least_room(links, ends[1]) > 0;
    across_gaps += room < 0 && ends_close;
    made += own.has_value();
    not_made += !own;
    if (!own) continue;
    EXPECT_NEAR(own->to - own->from, motion.to - motion.from, 1e-12);
    EXPECT_NEAR(std::remainder(own->from - motion.from, kTurn), 0, 1e-12);
  }
  EXPECT_GT(made, 3000);
  EXPECT_GT(not_made, 3000);
  EXPECT_GT(across_gaps, 500);
}

}  // namespace
}  // namespace cognate::motion_within_test
