#include "problems/linkage/linkage_constraints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems::linkage_constraints_test {
namespace {

using L = Lengths<double>;

bool all_met(const LinkageConstraints& constraints, const L& links) {
  std::vector<double> values(constraints.count());
  constraints.evaluate(links, values, {});
  return std::all_of(values.begin(), values.end(), [](double c) { return c >= 0; });
}

/// Grashof's rule by sorting, independent of the half spaces.
bool is_crank_rocker(const L& l) {
  std::vector<double> sorted{l.crank, l.coupler, l.rocker, l.frame};
  std::sort(sorted.begin(), sorted.end());
  return l.crank == sorted[0] && sorted[0] + sorted[3] <= sorted[1] + sorted[2];
}

L random_links(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.1, 1.0);
  return {length(random), length(random), length(random), length(random)};
}

TEST(ConfiningClass, IsThatOfATurningCrankWhereTransmissionIsLimited) {
  const L crank_rocker{1, 3, 3, 3.5}, double_crank{3, 3, 3.5, 1}, triple{2, 1, 2.2, 3.9};
  Constraints constraints;
  EXPECT_EQ(confining_class(constraints, crank_rocker), std::nullopt);
  constraints.transmission_angle = Range{0.5, 2.5};
  EXPECT_EQ(confining_class(constraints, crank_rocker), RequiredClass::crank_rocker);
  EXPECT_EQ(confining_class(constraints, double_crank), RequiredClass::double_crank);
  EXPECT_EQ(confining_class(constraints, triple), std::nullopt);
  constraints.required_class = RequiredClass::double_rocker;
  EXPECT_EQ(confining_class(constraints, crank_rocker), RequiredClass::double_rocker);
}

TEST(LinkageConstraints, HalfSpacesAreTheCrankRocker) {
  const LinkageConstraints constraints({.required_class = RequiredClass::crank_rocker}, 1.0);
  std::mt19937_64 random(1);
  int crank_rockers = 0;
  for (int i = 0; i < 20000; ++i) {
    const L links = random_links(random);
    EXPECT_EQ(all_met(constraints, links), is_crank_rocker(links));
    crank_rockers += is_crank_rocker(links);
  }
  EXPECT_GT(crank_rockers, 500);
}

/// A common factor brings all lengths within their ranges, looked for on a grid with all the
/// factors at which one of them reaches an end of its range.
bool fits_by_some_factor(const std::array<Range, 4>& ranges, const L& links) {
  const std::array<double, 4> lengths{links.crank, links.coupler, links.rocker, links.frame};
  std::vector<double> factors{1};
  for (std::size_t i = 0; i < 4; ++i) {
    if (ranges[i].min > 0) factors.push_back(ranges[i].min / lengths[i]);
    if (std::isfinite(ranges[i].max)) factors.push_back(ranges[i].max / lengths[i]);
  }
  return std::ranges::any_of(factors, [&](double factor) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double length = factor * lengths[i];
      if (length < ranges[i].min * (1 - 1e-12) || length > ranges[i].max * (1 + 1e-12))
        return false;
    }
    return true;
  });
}

TEST(LinkageConstraints, ProportionsAreMetWhereSomeFactorBringsAllLengthsIntoTheirRanges) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> length(1, 4);
  int fitting = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<Range, 4> ranges;
    for (Range& range : ranges) {
      const double end = length(random), other = length(random);
      range = {std::min(end, other), std::max(end, other)};
      if (random() % 5 == 0) range.min = 0;
      if (random() % 5 == 0) range.max = std::numeric_limits<double>::infinity();
    }
    if (random() % 2 == 0) ranges[random() % 4] = {2, 2};
    const LinkageConstraints constraints({.proportions = ranges}, 1.0);
    const L links = random_links(random);
    const bool fits = fits_by_some_factor(ranges, links);
    EXPECT_EQ(all_met(constraints, links), fits);
    fitting += fits;
  }
  EXPECT_GT(fitting, 1000);
  EXPECT_LT(fitting, 19000);
}

TEST(LinkageConstraints, TwoGivenLengthsFixTheirRatio) {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  const std::array<Range, 4> ranges{Range{2, 2}, {6, 6}, {0, kOpen}, {0, kOpen}};
  const LinkageConstraints constraints({.proportions = ranges}, 1.0);
  EXPECT_TRUE(all_met(constraints, {1, 3, 5, 0.1}));
  EXPECT_FALSE(all_met(constraints, {1, 3.001, 5, 0.1}));
  EXPECT_FALSE(all_met(constraints, {1, 2.999, 5, 0.1}));
}

TEST(ConfiningClass, IsTheNearestWhereTheCrankMustTurn) {
  const Constraints constraints{.full_turn = true};
  EXPECT_EQ(confining_class(constraints, {1, 3, 3, 3.5}), RequiredClass::crank_rocker);
  EXPECT_EQ(confining_class(constraints, {3, 3, 3.5, 1}), RequiredClass::double_crank);
  EXPECT_EQ(confining_class(constraints, {2, 1, 2.2, 3.9}), RequiredClass::crank_rocker);
}

TEST(LinkageConstraints, GrashofAndItsOppositePartAllLinkages) {
  const LinkageConstraints grashof({.required_class = RequiredClass::grashof}, 1.0);
  const LinkageConstraints other({.required_class = RequiredClass::non_grashof}, 1.0);
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const L links = random_links(random);
    EXPECT_NE(all_met(grashof, links), all_met(other, links));
  }
}

TEST(LinkageConstraints, TransmissionLimitsAreThoseOfTheMovingLinkage) {
  const Range limits{0.7, 2.2};
  const LinkageConstraints constraints(
      {.required_class = RequiredClass::crank_rocker, .transmission_angle = limits}, 1.0);
  ASSERT_TRUE(constraints.limits_transmission());
  std::mt19937_64 random(3);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const L l = random_links(random);
    if (!is_crank_rocker(l)) continue;
    const Motion motion({{0, 0}, {l.frame, 0}, l.crank, l.coupler, l.rocker, Assembly::open, {}});
    bool within = true;
    for (int step = 0; step < 360; ++step) {
      const auto pose = motion.at(step * kPi / 180);
      ASSERT_TRUE(pose);
      within &= pose->transmission_angle >= limits.min && pose->transmission_angle <= limits.max;
    }
    EXPECT_EQ(within, all_met(constraints, l));
    met += within;
  }
  EXPECT_GT(met, 50);
}

TEST(LinkageConstraints, GradientsAgreeWithCentralDifferences) {
  std::mt19937_64 random(4);
  for (const auto required : {RequiredClass::crank_rocker, RequiredClass::double_crank,
                              RequiredClass::grashof, RequiredClass::triple_rocker}) {
    const LinkageConstraints constraints(
        {.required_class = required, .transmission_angle = Range{0.5, 2.5}, .link_ratio_max = 3.0},
        2.0);
    const auto n = static_cast<std::size_t>(constraints.count());
    for (int i = 0; i < 100; ++i) {
      const L links = random_links(random);
      std::vector<double> values(n), up(n), down(n);
      std::vector<L> gradient(n);
      constraints.evaluate(links, values, gradient);
      for (const auto link : {&L::crank, &L::coupler, &L::rocker, &L::frame}) {
        const double step = 1e-6;
        L higher = links, lower = links;
        higher.*link += step;
        lower.*link -= step;
        constraints.evaluate(higher, up, {});
        constraints.evaluate(lower, down, {});
        for (std::size_t k = 0; k < n; ++k) {
          const double slope = (up[k] - down[k]) / (2 * step);
          EXPECT_NEAR(gradient[k].*link, slope, 1e-6 * (1 + std::abs(slope)));
        }
      }
    }
  }
}

/// The ratio by the kernel, which knows the limit positions.
TEST(LinkageConstraints, TimeRatioLimitsAreThoseOfTheMovingLinkage) {
  const Range limits{1.1, 1.4};
  const LinkageConstraints constraints(
      {.required_class = RequiredClass::crank_rocker, .time_ratio = limits}, 1.0);
  std::mt19937_64 random(5);
  int within = 0, seen = 0;
  while (seen < 3000) {
    const L links = random_links(random);
    if (!is_crank_rocker(links)) continue;
    ++seen;
    const double ratio = time_ratio(links).value();
    EXPECT_EQ(all_met(constraints, links), ratio >= limits.min && ratio <= limits.max) << ratio;
    within += ratio >= limits.min && ratio <= limits.max;
  }
  EXPECT_GT(within, 300);
}

TEST(LinkageConstraints, TimeRatioSlopesAreThoseOfDifferences) {
  const LinkageConstraints constraints(
      {.required_class = RequiredClass::crank_rocker, .time_ratio = Range{1.1, 1.4}}, 1.0);
  const L links{0.3, 0.9, 0.7, 0.8};
  const auto values = [&](const L& at) {
    std::vector<double> c(constraints.count());
    constraints.evaluate(at, c, {});
    return c;
  };
  std::vector<double> c(constraints.count());
  std::vector<L> slopes(c.size());
  constraints.evaluate(links, c, slopes);
  for (const auto link : {&L::crank, &L::coupler, &L::rocker, &L::frame}) {
    const double h = 1e-6;
    L left = links, right = links;
    left.*link -= h;
    right.*link += h;
    for (std::size_t i = 0; i < c.size(); ++i) {
      EXPECT_NEAR(slopes[i].*link, (values(right)[i] - values(left)[i]) / (2 * h), 1e-8);
    }
  }
}

}  // namespace
}  // namespace cognate::problems::linkage_constraints_test
