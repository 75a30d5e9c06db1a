// Points that fill a cube: the published ones, the strata that define each kind, and any of them
// alone as in sequence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "problems/study/sampling.hpp"

namespace cognate::problems::study_sampling_test {
namespace {

constexpr Sampling kAll[] = {Sampling::sobol, Sampling::halton, Sampling::latin, Sampling::random};

std::vector<double> points(Sampling sampling, std::size_t dimensions, std::int64_t count,
                           std::uint64_t seed) {
  std::vector<double> all(static_cast<std::size_t>(count) * dimensions);
  unit_points(sampling, dimensions, count, seed)(0, all);
  return all;
}

/// The coordinates of one dimension.
std::vector<double> column(const std::vector<double>& points, std::size_t dimensions,
                           std::size_t d) {
  std::vector<double> values;
  for (std::size_t i = d; i < points.size(); i += dimensions) values.push_back(points[i]);
  return values;
}

/// Whether of `values` each of as many equal parts of [0, 1) holds one.
::testing::AssertionResult one_in_each_part(const std::vector<double>& values) {
  std::set<std::size_t> parts;
  for (const double value : values) {
    parts.insert(static_cast<std::size_t>(value * static_cast<double>(values.size())));
  }
  if (parts.size() == values.size() && *parts.rbegin() < values.size()) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << parts.size() << " of " << values.size() << " parts";
}

/// The L2 star discrepancy (Warnock 1972).
double discrepancy(const std::vector<double>& points, std::size_t dimensions) {
  const auto n = static_cast<double>(points.size() / dimensions);
  double single = 0, pairs = 0;
  for (std::size_t i = 0; i < points.size(); i += dimensions) {
    double product = 1;
    for (std::size_t d = 0; d < dimensions; ++d) product *= 1 - points[i + d] * points[i + d];
    single += product;
    for (std::size_t j = 0; j < points.size(); j += dimensions) {
      double both = 1;
      for (std::size_t d = 0; d < dimensions; ++d) {
        both *= 1 - std::max(points[i + d], points[j + d]);
      }
      pairs += both;
    }
  }
  const auto s = static_cast<double>(dimensions);
  return std::sqrt(std::pow(3, -s) - std::pow(2, 1 - s) / n * single + pairs / (n * n));
}

// The first points of Joe and Kuo's own program (new-joe-kuo-6.21201, three dimensions).
TEST(Sobol, IsThePublishedSequence) {
  const std::vector<double> published = {
      0,     0,     0,     0.5,   0.5,    0.5,    0.75,   0.25,   0.25,   0.25,
      0.75,  0.75,  0.375, 0.375, 0.625,  0.875,  0.875,  0.125,  0.625,  0.125,
      0.875, 0.125, 0.625, 0.375, 0.1875, 0.3125, 0.9375, 0.6875, 0.8125, 0.4375};
  EXPECT_EQ(points(Sampling::sobol, 3, 10, 0), published);
}

TEST(Sobol, AnyBlockOfAPowerOfTwoIsEvenWhateverTheSeed) {
  for (const std::uint64_t seed : {0, 1, 77}) {
    for (const std::int64_t first : {0, 64, 192}) {
      std::vector<double> block(std::size_t{64} * 5);
      sobol_points(5, seed)(first, block);
      for (std::size_t d = 0; d < 5; ++d) {
        EXPECT_TRUE(one_in_each_part(column(block, 5, d))) << seed << " " << first << " " << d;
      }
    }
  }
}

// The first two dimensions are a (0, 2)-sequence: each elementary interval of area 2^-8 holds one
// of 2^8 points (Niederreiter 1992).
TEST(Sobol, TheFirstTwoDimensionsFillEveryElementaryInterval) {
  for (const std::uint64_t seed : {0, 5}) {
    const auto plane = points(Sampling::sobol, 2, 256, seed);
    for (int bits = 0; bits <= 8; ++bits) {
      std::set<std::pair<int, int>> cells;
      for (std::size_t i = 0; i < plane.size(); i += 2) {
        cells.emplace(static_cast<int>(std::ldexp(plane[i], bits)),
                      static_cast<int>(std::ldexp(plane[i + 1], 8 - bits)));
      }
      EXPECT_EQ(cells.size(), 256U) << seed << " " << bits;
    }
  }
}

TEST(Halton, IsThePublishedSequence) {
  const std::vector<double> published = {0,     0,       0.5,   1.0 / 3, 0.25,   2.0 / 3,
                                         0.75,  1.0 / 9, 0.125, 4.0 / 9, 0.625,  7.0 / 9,
                                         0.375, 2.0 / 9, 0.875, 5.0 / 9, 0.0625, 8.0 / 9};
  const auto computed = points(Sampling::halton, 2, 9, 0);
  for (std::size_t i = 0; i < published.size(); ++i) EXPECT_NEAR(computed[i], published[i], 1e-15);
}

TEST(Halton, EveryPowerOfItsBaseFillsEveryPart) {
  const std::size_t primes[] = {2, 3, 5, 7, 11, 13};
  for (const std::uint64_t seed : {1, 9}) {
    const auto all = points(Sampling::halton, 6, 14641, seed);
    for (std::size_t d = 0; d < 6; ++d) {
      auto values = column(all, 6, d);
      std::size_t power = primes[d];
      while (power * primes[d] <= 14641) power *= primes[d];
      values.resize(power);
      // A point may stand on the border of its part: half a part of a much finer grid aside.
      for (double& value : values) value += 1e-12;
      EXPECT_TRUE(one_in_each_part(values)) << seed << " " << d;
    }
  }
}

TEST(Latin, EveryPartOfEveryAxisHoldsOnePoint) {
  for (const std::int64_t count : {1, 2, 3, 10, 97, 4096, 5000}) {
    const auto all = points(Sampling::latin, 3, count, 4);
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_TRUE(one_in_each_part(column(all, 3, d))) << count;
    }
  }
}

TEST(Latin, AxesArePairedAtRandom) {
  constexpr int kCount = 4000;
  const auto all = points(Sampling::latin, 2, kCount, 1);
  const auto x = column(all, 2, 0), y = column(all, 2, 1);
  double covariance = 0, serial = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    covariance += (x[i] - 0.5) * (y[i] - 0.5);
    serial += (x[i] - 0.5) * (x[(i + 1) % kCount] - 0.5);
  }
  // Of independent numbers both are normal of deviation sqrt(n)/12.
  EXPECT_LT(std::abs(covariance), 5 * std::sqrt(kCount) / 12);
  EXPECT_LT(std::abs(serial), 5 * std::sqrt(kCount) / 12);
}

TEST(RandomPermutation, IsABijectionOfAnyLength) {
  for (const std::uint64_t n : {1U, 2U, 5U, 16U, 17U, 1000U}) {
    std::set<std::uint64_t> images;
    const RandomPermutation permutation(n, 12345);
    for (std::uint64_t i = 0; i < n; ++i) images.insert(permutation(i));
    EXPECT_EQ(images.size(), n);
    EXPECT_EQ(*images.rbegin(), n - 1);
  }
}

// Each of 24 orders of four should come about as often as any other.
TEST(RandomPermutation, KeysChooseAmongAllOrders) {
  std::map<std::string, int> seen;
  constexpr int kKeys = 4800;
  for (std::uint64_t key = 0; key < kKeys; ++key) {
    const RandomPermutation permutation(4, key);
    std::string order;
    for (std::uint64_t i = 0; i < 4; ++i) order += static_cast<char>('0' + permutation(i));
    ++seen[order];
  }
  EXPECT_GE(seen.size(), 12U);  // a network over two bits reaches the even ones
  for (const auto& [order, times] : seen) EXPECT_LT(times, kKeys / 4) << order;
}

TEST(Random, HasTheMomentsOfUniformNumbers) {
  constexpr std::size_t kCount = 100'000;
  const auto values = points(Sampling::random, 1, kCount, 3);
  double sum = 0, squares = 0, serial = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    sum += values[i] - 0.5;
    squares += (values[i] - 0.5) * (values[i] - 0.5) - 1.0 / 12;
    serial += (values[i] - 0.5) * (values[(i + 1) % kCount] - 0.5);
  }
  const double root = std::sqrt(static_cast<double>(kCount));
  EXPECT_LT(std::abs(sum), 5 * root * std::sqrt(1.0 / 12));
  EXPECT_LT(std::abs(squares), 5 * root * std::sqrt(1.0 / 180));
  EXPECT_LT(std::abs(serial), 5 * root / 12);
}

TEST(Samplings, EvenOnesLieMoreEvenlyThanRandomOnes) {
  const double random = discrepancy(points(Sampling::random, 4, 512, 1), 4);
  EXPECT_LT(discrepancy(points(Sampling::sobol, 4, 512, 1), 4), random / 3);
  EXPECT_LT(discrepancy(points(Sampling::halton, 4, 512, 1), 4), random / 3);
}

// Coordinates in the bases 53 to 71 run in step for the first hundred points unless permuted.
TEST(Halton, LargeBasesDoNotRunInStep) {
  const auto all = points(Sampling::halton, 20, 100, 1);
  const auto x = column(all, 20, 18), y = column(all, 20, 19);
  double covariance = 0;
  for (std::size_t i = 0; i < x.size(); ++i) covariance += (x[i] - 0.5) * (y[i] - 0.5);
  EXPECT_LT(std::abs(covariance / 100 * 12), 0.4);  // 0.82 unpermuted
}

TEST(Samplings, APointHangsOnItsNumberAndTheSeedAlone) {
  for (const Sampling sampling : kAll) {
    const auto all = points(sampling, 3, 100, 7);
    auto unit = unit_points(sampling, 3, 100, 7);
    for (const std::int64_t first : {99, 0, 31, 32, 1, 0, 60}) {
      std::vector<double> some(3 *
                               static_cast<std::size_t>(std::min<std::int64_t>(5, 100 - first)));
      unit(first, some);
      EXPECT_TRUE(std::ranges::equal(
          some, std::span(all).subspan(3 * static_cast<std::size_t>(first), some.size())))
          << static_cast<int>(sampling) << " " << first;
    }
    EXPECT_NE(points(sampling, 3, 100, 8), all);
    for (const double x : all) EXPECT_TRUE(x >= 0 && x < 1);
  }
}

}  // namespace
}  // namespace cognate::problems::study_sampling_test
