/// The transmission angle over the way of a crank against the law of cosines along that way.
#include "problems/linkage/driven_range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cognate::problems::driven_range_test {
namespace {

struct Case {
  DrivenCrank crank;
  Range increments;
};

Case random_case(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double from = uniform(-2, 0);
  return {{{uniform(0.3, 2), uniform(0.3, 2), uniform(0.3, 2), uniform(0.3, 2)}, uniform(-10, 10)},
          {from, from + uniform(0, 5)}};
}

/// cos μ, beyond ±1 where the linkage does not close, by the crank pin's place.
double textbook_cosine(const DrivenCrank& at, double increment) {
  const double x = at.links.frame - at.links.crank * std::cos(increment + at.offset);
  const double y = at.links.crank * std::sin(increment + at.offset);
  const double b = at.links.coupler, c = at.links.rocker;
  return (b * b + c * c - x * x - y * y) / (2 * b * c);
}

TEST(DrivenRange, IsTheLeastOverTheWholeWay) {
  std::mt19937_64 random(11);
  Constraints constraints;
  constraints.transmission_angle = Range{0.6, 2.3};
  int inside = 0, tested = 0;
  for (int n = 0; n < 1000; ++n) {
    const auto [crank, increments] = random_case(random);
    const DrivenRange range(constraints, increments);
    ASSERT_EQ(range.count(), 2);
    std::array<double, 2> values{};
    range.evaluate(crank, values, {});
    double greatest = -1e9, least = 1e9;
    constexpr int kSteps = 2000;
    for (int k = 0; k <= kSteps; ++k) {
      const double at = increments.min + (increments.max - increments.min) * k / kSteps;
      greatest = std::max(greatest, textbook_cosine(crank, at));
      least = std::min(least, textbook_cosine(crank, at));
    }
    const double scale =
        crank.links.crank * crank.links.frame / (crank.links.coupler * crank.links.rocker);
    const double missed = 1e-10 + 5 * 5 * scale / (kSteps * double(kSteps));
    EXPECT_NEAR(values[0], std::cos(0.6) - greatest, missed) << n;
    EXPECT_NEAR(values[1], least - std::cos(2.3), missed) << n;
    inside += values[0] > 0 && values[1] > 0;
    ++tested;
  }
  EXPECT_EQ(tested, 1000);
  EXPECT_GT(inside, 30);
  EXPECT_LT(inside, 970);
}

TEST(DrivenRange, HasTheDerivativesOfItsValues) {
  std::mt19937_64 random(12);
  Constraints constraints;
  constraints.transmission_angle = Range{0.6, 2.3};
  int tested = 0;
  for (int n = 0; n < 500; ++n) {
    const auto [crank, increments] = random_case(random);
    const DrivenRange range(constraints, increments);
    std::array<double, 2> value{}, up{}, down{};
    std::array<DrivenSlopes, 2> slopes{}, slopes_up{}, slopes_down{};
    range.evaluate(crank, value, slopes);
    std::array<double, 25> hessian{};
    const std::array<double, 2> weights{0.7, -1.3};
    range.add_hessian(crank, weights, hessian);
    constexpr double kStep = 1e-6;
    for (std::size_t i = 0; i < 5; ++i) {
      const auto moved = [&](double by) {
        DrivenCrank other = crank;
        double* const all[] = {&other.links.crank, &other.links.coupler, &other.links.rocker,
                               &other.links.frame, &other.offset};
        *all[i] += by;
        return other;
      };
      range.evaluate(moved(kStep), up, slopes_up);
      range.evaluate(moved(-kStep), down, slopes_down);
      for (std::size_t row = 0; row < 2; ++row) {
        const double slope = (up[row] - down[row]) / (2 * kStep);
        EXPECT_NEAR(slopes[row][i], slope, 1e-4 * (1 + std::abs(slope))) << n << ' ' << i;
      }
      for (std::size_t j = 0; j < 5; ++j) {
        const double curvature = (weights[0] * (slopes_up[0][j] - slopes_down[0][j]) +
                                  weights[1] * (slopes_up[1][j] - slopes_down[1][j])) /
                                 (2 * kStep);
        EXPECT_NEAR(hessian[5 * i + j], curvature, 1e-4 * (1 + std::abs(curvature)));
        ++tested;
      }
    }
  }
  EXPECT_EQ(tested, 500 * 25);
}

TEST(DrivenRange, IsTheClosingOfTheLinkageWithoutALimit) {
  Constraints constraints;
  EXPECT_EQ(DrivenRange(constraints, {0, 1}).count(), 2);
  constraints.no_circuit_defect = constraints.no_order_defect = false;
  EXPECT_EQ(DrivenRange(constraints, {0, 1}).count(), 0);
  // A triple rocker: its crank does not pass the frame's line.
  const DrivenCrank crank{{1, 1, 0.4, 2.2}, 0};
  std::array<double, 2> values{};
  DrivenRange(Constraints{}, {-0.2, 0.2}).evaluate(crank, values, {});
  EXPECT_GT(values[0], 0);
  EXPECT_GT(values[1], 0);
  DrivenRange(Constraints{}, {0.2, 3}).evaluate(crank, values, {});
  EXPECT_GT(values[0], 0);
  EXPECT_LT(values[1], 0);
}

}  // namespace
}  // namespace cognate::problems::driven_range_test
