#include "synthesis/exact/freudenstein.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/chebyshev.hpp"

namespace cognate::synthesis::freudenstein_test {
namespace {

constexpr double pi = kPi;
constexpr double degree = pi / 180;

// Li Bincheng, Xu Chao, Mechanism Theory with MATLAB (2011), example 3-6, recomputed with 30
// digits.
TEST(Freudenstein, SolvesTheTextbookPairs) {
  const std::array<AnglePair, 3> pairs{AnglePair{45 * degree, 50 * degree},
                                       {90 * degree, 80 * degree},
                                       {135 * degree, 110 * degree}};
  const auto ratios = freudenstein_exact(pairs);
  ASSERT_TRUE(ratios);
  EXPECT_NEAR(ratios->p[0], 1.533039584971189, 2e-14);
  EXPECT_NEAR(ratios->p[1], -1.0628433601705558, 2e-14);
  EXPECT_NEAR(ratios->p[2], 0.7804868511119958, 2e-14);
  EXPECT_LT(ratios->residual, 1e-15);
  const FreudensteinLinkage linkage = freudenstein_linkage(ratios->p);
  ASSERT_EQ(linkage.outcome, FreudensteinOutcome::linkage);
  EXPECT_NEAR(linkage.links.coupler, 1.7830234404270595, 5e-14);
  EXPECT_NEAR(linkage.links.rocker, 1.533039584971189, 5e-14);
  EXPECT_NEAR(linkage.links.frame, 1.442394657972159, 5e-14);
  EXPECT_EQ(linkage.input_turn, 0);
  EXPECT_EQ(linkage.output_turn, 0);
}

/// Pairs of a linkage with the given turns of the reference directions.
std::vector<AnglePair> pairs_of(const FourBar& linkage, double input_turn, double output_turn,
                                int count) {
  const Motion motion(linkage);
  std::vector<AnglePair> pairs;
  for (int i = 0; i < count; ++i) {
    const double crank = 0.4 + 1.1 * i / (count - 1);
    const auto pose = motion.at(crank);
    if (!pose) return {};
    pairs.push_back({crank - input_turn, pose->rocker_angle - output_turn});
  }
  return pairs;
}

// Answer first: a linkage, three of its positions with directions turned, and the linkage again.
TEST(Freudenstein, RecoversPlantedLinkagesWithTurnedDirections) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> length(0.3, 3.0);
  int tried = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    FourBar planted;
    planted.pivot_d = {length(random), 0};
    planted.crank = 1;
    planted.coupler = length(random);
    planted.rocker = length(random);
    planted.assembly = trial % 2 ? Assembly::open : Assembly::crossed;
    const double input_turn = trial % 3 == 0 ? pi : 0, output_turn = trial % 5 == 0 ? pi : 0;
    const auto pairs = pairs_of(planted, input_turn, output_turn, 3);
    if (pairs.empty()) continue;
    const auto ratios = freudenstein_exact(std::span<const AnglePair, 3>(pairs));
    ASSERT_TRUE(ratios) << trial;
    const FreudensteinLinkage found = freudenstein_linkage(ratios->p);
    const double tolerance = 1e-13 * ratios->condition;
    ASSERT_EQ(found.outcome, FreudensteinOutcome::linkage) << trial;
    EXPECT_NEAR(found.links.coupler, planted.coupler, tolerance) << trial;
    EXPECT_NEAR(found.links.rocker, planted.rocker, tolerance) << trial;
    EXPECT_NEAR(found.links.frame, planted.pivot_d.x, tolerance) << trial;
    EXPECT_EQ(found.input_turn, input_turn) << trial;
    EXPECT_EQ(found.output_turn, output_turn) << trial;
    ++tried;
  }
  EXPECT_GT(tried, 500);
}

TEST(Freudenstein, FitsManyPairsOfOneLinkage) {
  FourBar planted;
  planted.pivot_d = {2.1, 0};
  planted.crank = 1;
  planted.coupler = 1.7;
  planted.rocker = 1.9;
  const auto pairs = pairs_of(planted, 0, 0, 9);
  ASSERT_EQ(pairs.size(), 9u);
  const std::vector<double> weights{1, 2, 3, 4, 5, 4, 3, 2, 1};
  for (const auto& used : {std::vector<double>{}, weights}) {
    const auto ratios = freudenstein_fit(pairs, used);
    ASSERT_TRUE(ratios);
    const FreudensteinLinkage found = freudenstein_linkage(ratios->p);
    EXPECT_NEAR(found.links.coupler, 1.7, 1e-9);
    EXPECT_NEAR(found.links.rocker, 1.9, 1e-9);
    EXPECT_NEAR(found.links.frame, 2.1, 1e-9);
    EXPECT_LT(ratios->residual, 1e-10);
  }
}

TEST(Freudenstein, NamesDegenerateCases) {
  const std::array<AnglePair, 3> same{AnglePair{0.3, 0.5}, {0.3, 0.5}, {1.0, 1.2}};
  EXPECT_FALSE(freudenstein_exact(same));
  // Equal increments of crank and rocker make the second column constant.
  const std::array<AnglePair, 3> parallel{AnglePair{0.3, 0.5}, {0.6, 0.8}, {1.0, 1.2}};
  EXPECT_FALSE(freudenstein_exact(parallel));
  EXPECT_EQ(freudenstein_linkage({0, 1, 1}).outcome, FreudensteinOutcome::no_rocker);
  EXPECT_EQ(freudenstein_linkage({1, 0, 1}).outcome, FreudensteinOutcome::infinite_frame);
  const auto imaginary = freudenstein_linkage({1, -1, 2});
  EXPECT_EQ(imaginary.outcome, FreudensteinOutcome::imaginary_coupler);
  EXPECT_EQ(imaginary.coupler_squared, -1);
}

// Li, Xu 2011, example 3-7.
TEST(ChebyshevSpacing, GivesTheTextbookAbscissae) {
  const auto x = chebyshev_spacing(1, 2, 3);
  ASSERT_EQ(x.size(), 3u);
  EXPECT_NEAR(x[0], 1.0669872981077806, 1e-15);
  EXPECT_EQ(x[1], 1.5);
  EXPECT_NEAR(x[2], 1.9330127018922194, 1e-15);
}

}  // namespace
}  // namespace cognate::synthesis::freudenstein_test
