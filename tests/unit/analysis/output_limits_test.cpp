/// Extremes of an output next to positions that are all but undetermined: against a scan by closed
/// forms, and at a bounded cost where rounding is all that is seen.
#include "analysis/mechanism/output_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/numbers/constants.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate::output_limits_test {
namespace {

/// A crank of length 1 whose pin passes the pivot of a dyad of two equal links, `length` each, at
/// the distance `least`: there the dyad makes half a turn while the crank moves by about `least`.
struct Passing {
  double angle = 0;  ///< of the crank where its pin is nearest to the pivot
  double least = 0;
  double length = 0;
  double sense = 1;  ///< of the assembly

  Vec2d pivot() const { return {(1 + least) * std::cos(angle), (1 + least) * std::sin(angle)}; }

  Mechanism<double> mechanism() const {
    Mechanism<double> mechanism;
    mechanism.drive = Crank<double>{{0, 0}, 1};
    mechanism.dyads.emplace_back(Rrr<double>{
        {1, {1, 0}}, {0, pivot()}, length, length, sense > 0 ? Assembly::open : Assembly::crossed});
    return mechanism;
  }

  /// The direction of the second link, from the pivot to the inner joint, where the crank stands
  /// `way` beyond `angle`; modulo 2π. In axes turned by `angle`, where nothing cancels.
  long double direction(long double way) const {
    const long double half = std::sin(way / 2);
    const long double x = -2 * half * half - static_cast<long double>(least), y = std::sin(way);
    const long double share = std::hypot(x, y) / (2 * static_cast<long double>(length));
    return static_cast<long double>(angle) + std::atan2(y, x) -
           static_cast<long double>(sense) * std::acos(share);
  }
};

struct Extremes {
  double least = 0;
  double greatest = 0;
};

/// The extremes of a passing dyad's second link over a turn that begins `before` the passing,
/// from its direction there: at places crowded about the passing, and at the root of the slope.
Extremes scanned(const Passing& passing, double before) {
  constexpr int kPlaces = 200'000;
  constexpr long double kWhole = 2 * std::numbers::pi_v<long double>;
  const long double first = passing.direction(-static_cast<long double>(before));
  long double last = first, least = first, greatest = first;
  const long double low = std::asinh(-before / passing.least);
  const long double high = std::asinh((kTurn - before) / passing.least);
  for (int i = 1; i <= kPlaces; ++i) {
    const long double way = passing.least * std::sinh(low + (high - low) * i / kPlaces);
    last += std::remainder(passing.direction(way) - last, kWhole);
    least = std::min(least, last);
    greatest = std::max(greatest, last);
  }
  return {static_cast<double>(least - first), static_cast<double>(greatest - first)};
}

TEST(OutputLimits, ExtremesNextToAPassingAreThoseOfAScan) {
  test::ChainMaker random(11);
  for (int i = 0; i < 16; ++i) {
    const Passing passing{random.uniform(-3, 3), std::pow(10, random.uniform(-7, -1)),
                          random.uniform(1.2, 3), i % 2 == 0 ? 1.0 : -1.0};
    const double before = random.uniform(0.1, 3);
    SCOPED_TRACE(::testing::Message() << passing.angle << ' ' << passing.least << ' '
                                      << passing.length << ' ' << before);
    const auto mechanism = passing.mechanism();
    const double start = passing.angle - before;
    const auto ranges = follow(mechanism, start, start + kTurn);
    ASSERT_EQ(ranges.runs.size(), 1u);
    const auto output = output_range(mechanism, ranges, travels(mechanism)[3]);
    ASSERT_TRUE(output);
    const Extremes expected = scanned(passing, before);
    // The direction at the passing is known to the rounding of the pivot over `least`.
    const double tolerance = 1e-8 + 4e-15 / passing.least;
    EXPECT_NEAR(output->least.value - output->first.value, expected.least, tolerance);
    EXPECT_NEAR(output->greatest.value - output->first.value, expected.greatest, tolerance);
    EXPECT_LT(output->evaluations, 4000u);
  }
}

/// Dyads in a row, five of which have a change point at one angle of the crank: next to it rounding
/// is all that is left of the last ones, and could be refined without end.
TEST(OutputLimits, WhatIsOnlyRoundingIsNotRefinedWithoutEnd) {
  constexpr int kDyads = 18;
  const double crank = std::hypot(6, 4), rocker = std::hypot(2, 9);
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, crank};
  for (int i = 0; i < kDyads; ++i) {
    const double link = i == 0 ? 13 : 6, before = i == 1 ? 13 : 6;
    const Attached<double> pin =
        i == 0 ? Attached<double>{1, {crank, 0}} : Attached<double>{2 * i, {before, 0}};
    mechanism.dyads.emplace_back(
        Rrr<double>{pin, {0, {8.0 + 6 * i, 0}}, link, rocker, Assembly::open});
  }
  const auto ranges = follow(mechanism, -319.7 * kDegree, -28.2 * kDegree);
  const auto output = output_range(mechanism, ranges, travels(mechanism).back());
  ASSERT_TRUE(output);
  EXPECT_LT(output->evaluations, 30'000u);
}

}  // namespace
}  // namespace cognate::output_limits_test
