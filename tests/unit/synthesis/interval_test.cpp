/// Intervals hold what their ends and points between give, also where an end is infinite.
#include "synthesis/bounds/interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace cognate::synthesis {
namespace {

bool holds(const Interval& range, double x) {
  return range.low <= x && x <= range.high;
}

TEST(Interval, QuotientsByWhatReachesZeroHoldEveryPoint) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-2, 2), share(0, 1);
  for (int k = 0; k < 20'000; ++k) {
    const double p = any(random), q = any(random), r = any(random), s = any(random);
    const Interval a(std::min(p, q), std::max(p, q)), b(0, 1 + share(random));
    // Ends at 0 are those that a product with an infinite end may lose.
    const Interval c = k % 3 == 0   ? Interval(-std::abs(r), 0)
                       : k % 3 == 1 ? Interval(0, std::abs(r))
                                    : Interval(std::min(r, s), std::max(r, s));
    const Interval quotient = a / b, product = quotient * c, other = c * quotient;
    for (int i = 0; i < 10; ++i) {
      const double x = a.low + share(random) * (a.high - a.low);
      const double y = b.high * (1 - share(random));
      const double z = i == 0 ? c.low : i == 1 ? c.high : c.low + share(random) * (c.high - c.low);
      ASSERT_TRUE(holds(quotient, x / y)) << k;
      ASSERT_TRUE(holds(product, x / y * z)) << k;
      ASSERT_TRUE(holds(other, x / y * z)) << k;
    }
  }
}

TEST(Interval, WhatIsNoNumberStaysNone) {
  const Interval none = Interval(1) / Interval(-1, 1);
  EXPECT_TRUE(std::isnan(none.low));
  const Interval product = none * Interval(0, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(product.low));
  EXPECT_TRUE(std::isnan(product.high));
}

}  // namespace
}  // namespace cognate::synthesis
