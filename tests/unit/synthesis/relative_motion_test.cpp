#include "synthesis/exact/motion/relative_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/motion/burmester_curves.hpp"
#include "synthesis/exact/motion/three_poses.hpp"
#include "synthesis/exact/motion/two_poses.hpp"

namespace cognate::synthesis::relative_motion_test {
namespace {

constexpr double degree = kPi / 180;

struct Random {
  std::mt19937_64 engine;
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
};

/// A four-bar and pairs of its angles, counted from start angles of their own.
struct Planted {
  FourBar linkage;
  double input_start = 0, output_start = 0;
  std::array<AnglePair, 5> pairs;
};

std::optional<Planted> planted(Random& random) {
  Planted result{{{0, 0},
                  {random(0.3, 3), 0},
                  random(0.3, 3),
                  random(0.3, 3),
                  random(0.3, 3),
                  Assembly::open,
                  std::nullopt},
                 random(-3, 3),
                 random(-3, 3),
                 {}};
  const Motion motion(result.linkage);
  const double start = random(0, 6.28), way = random(0.5, 4);
  for (std::size_t j = 0; j < 5; ++j) {
    const double crank = start + way * std::array{0.0, 0.3, 0.45, 0.8, 1.0}[j];
    const auto pose = motion.at(crank);
    if (!pose) return std::nullopt;
    result.pairs[j] = {crank - result.input_start, pose->rocker_angle - result.output_start};
  }
  return result;
}

Vec2d polar(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

// Li Bincheng, Xu Chao, Mechanism Theory with MATLAB (2011), example 3-6.
TEST(RelativeMotion, AgreesWithFreudensteinInTheTextbook) {
  const std::array<AnglePair, 3> pairs{AnglePair{45 * degree, 50 * degree},
                                       {90 * degree, 80 * degree},
                                       {135 * degree, 110 * degree}};
  const double frame = 1.442394657972159;
  const auto poses = crank_seen_from_rocker(pairs, frame);
  const DyadSolutions found = dyads_with_moving_pivot(std::span<const Pose, 3>(poses), {1, 0});
  ASSERT_EQ(found.count, 1);
  EXPECT_NEAR(found.storage[0].fixed.x, 1.533039584971189, 1e-13);
  EXPECT_NEAR(found.storage[0].fixed.y, 0, 1e-13);
  EXPECT_NEAR(found.storage[0].length, 1.7830234404270595, 1e-13);
}

/// Freudenstein's equation solved for three pairs, and the same linkage by inversion.
TEST(RelativeMotion, AgreesWithFreudenstein) {
  Random random{std::mt19937_64(1)};
  int linkages = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::array<AnglePair, 3> pairs;
    for (AnglePair& pair : pairs) pair = {random(-3, 3), random(-3, 3)};
    const auto ratios = freudenstein_exact(pairs);
    if (!ratios) continue;
    const FreudensteinLinkage linkage = freudenstein_linkage(ratios->p);
    if (linkage.outcome != FreudensteinOutcome::linkage) continue;
    ++linkages;
    const double frame = linkage.links.frame;
    const auto poses = crank_seen_from_rocker(pairs, frame);
    const DyadSolutions found =
        dyads_with_moving_pivot(std::span<const Pose, 3>(poses), polar(1, linkage.input_turn));
    ASSERT_EQ(found.count, 1);
    const GuidingDyad& coupler = found.storage[0];
    const double size = 1 + frame + linkage.links.rocker;
    const double bound = 1e-13 * ratios->condition * coupler.condition * size * size;
    const Vec2d c = polar(linkage.links.rocker, linkage.output_turn);
    EXPECT_LT(norm(coupler.fixed - c), bound);
    EXPECT_LT(std::abs(coupler.length - linkage.links.coupler), bound);
  }
  EXPECT_GT(linkages, 1000);
}

TEST(RelativeMotion, RecoversFivePlantedPairs) {
  int tested = 0;
  Random random{std::mt19937_64(2)};
  std::array<int, 5> counts{};
  for (int tried = 0; tried < 2000;) {
    const auto plant = planted(random);
    if (!plant) continue;
    ++tested;
    ++tried;
    const Lengths<double> links = lengths(plant->linkage);
    const auto poses = crank_seen_from_rocker(plant->pairs, links.frame);
    const Vec2d b = polar(links.crank, plant->input_start);
    const Vec2d c = polar(links.rocker, plant->output_start);
    const GuidingDyad coupler = rr_dyad(poses, b, c);
    EXPECT_LT(coupler.residual, 1e-13);
    const auto found = function_linkages(plant->pairs, links.frame);
    ++counts[found.size()];
    double best = 1e300;
    for (const FunctionLinkage& linkage : found) {
      best = std::min(best, norm(polar(linkage.links.crank, linkage.input_start) - b) +
                                norm(polar(linkage.links.rocker, linkage.output_start) - c));
    }
    EXPECT_LT(best, 1e-4) << tried;
  }
  EXPECT_EQ(counts[0] + counts[2] + counts[4], 0);  // the frame is the fourth
  EXPECT_GT(counts[1], 100);
  EXPECT_GT(counts[3], 100);
  EXPECT_GE(tested, 1800);
}

/// With two pairs B decides the bisector, with four a curve of couplers, of which the frame is one.
TEST(RelativeMotion, HasFewerPairsAsWell) {
  int tested = 0;
  Random random{std::mt19937_64(3)};
  for (int tried = 0; tried < 50;) {
    const auto plant = planted(random);
    if (!plant) continue;
    ++tested;
    ++tried;
    const Lengths<double> links = lengths(plant->linkage);
    const Vec2d b = polar(links.crank, plant->input_start);
    const Vec2d c = polar(links.rocker, plant->output_start);
    const auto two = crank_seen_from_rocker(std::span(plant->pairs).first(2), links.frame);
    const auto bisector = fixed_pivots_of(std::span<const Pose, 2>(two), b);
    ASSERT_TRUE(bisector);
    EXPECT_LT(std::abs(cross(bisector->direction, c - bisector->point)), 1e-11);
    const auto four = crank_seen_from_rocker(std::span(plant->pairs).first(4), links.frame);
    const BurmesterCurves curves(std::span<const Pose, 4>{four});
    const DyadSolutions found = curves.with_fixed_pivot_on({c, {0.6, 0.8}});
    double best = 1e300;
    for (const GuidingDyad& dyad : found.dyads()) best = std::min(best, norm(dyad.in_body - b));
    EXPECT_LT(best, 1e-7);
  }
  EXPECT_GE(tested, 45);
}

TEST(RelativeMotion, NamesWhatIsNoFourBar) {
  GuidingDyad slide;
  slide.kind = DyadKind::pr;
  EXPECT_FALSE(function_linkage(slide, 1));
  GuidingDyad frame;
  frame.length = 1;
  EXPECT_FALSE(function_linkage(frame, 1));
}

}  // namespace
}  // namespace cognate::synthesis::relative_motion_test
