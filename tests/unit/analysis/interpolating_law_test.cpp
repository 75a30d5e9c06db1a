// Polynomials by boundary conditions and splines: planted courses come back, and what has no
// solution is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "analysis/cam/motion_law.hpp"

namespace cognate::cam::interpolating_law_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using Pieces = std::vector<MotionPiece<double>>;

/// A polynomial in the share u of a segment over `over`.
struct Planted {
  std::vector<double> powers;
  double over = 1;

  /// Its derivative `order` by the cam angle.
  double operator()(double u, int order) const {
    Quad sum = 0;
    for (int k = static_cast<int>(powers.size()) - 1; k >= order; --k) {
      Quad factor = powers[static_cast<std::size_t>(k)];
      for (int i = 0; i < order; ++i) factor *= k - i;
      sum = sum * u + factor;
    }
    return static_cast<double>(sum / pow(Quad(over), order));
  }
};

std::array<double, 4> as_array(const FollowerMotion<double>& motion) {
  return {motion.displacement, motion.velocity, motion.acceleration, motion.jerk};
}

void expect_planted_motion(const Pieces& pieces, const Planted& planted, double tolerance) {
  for (const auto& piece : pieces) {
    for (const double t : {0.0, 0.13, 0.5, 0.77, 1.0}) {
      const auto motion = as_array(motion_at(piece, t));
      const double u = (piece.begin + piece.span * t) / planted.over;
      for (int order = 0; order < 4; ++order) {
        const double wanted = planted(u, order);
        EXPECT_NEAR(motion[static_cast<std::size_t>(order)], wanted,
                    tolerance * std::pow(planted.over, -order))
            << u << ' ' << order;
      }
    }
  }
}

MotionSegment polynomial_segment(double over, double rise,
                                 std::vector<MotionCondition> conditions) {
  MotionSegment segment;
  segment.law = MotionLaw::polynomial;
  segment.over = over;
  segment.rise = rise;
  segment.conditions = std::move(conditions);
  return segment;
}

TEST(PolynomialLaw, RestAtBothEndsGivesTheClassicalPolynomials) {
  std::vector<MotionCondition> conditions{{0, 1, 0}, {0, 2, 0}, {1, 1, 0}, {1, 2, 0}};
  for (const MotionLaw law : {MotionLaw::polynomial_345, MotionLaw::polynomial_4567}) {
    Pieces found, named;
    MotionSegment segment = polynomial_segment(1.25, -3, conditions);
    ASSERT_TRUE(append_pieces(segment, 0.5, 7, 3, found));
    segment.law = law;
    ASSERT_TRUE(append_pieces(segment, 0.5, 7, 3, named));
    EXPECT_EQ(found[0].segment, 3);
    for (int i = 0; i <= 64; ++i) {
      const auto a = as_array(motion_at(found[0], i / 64.0)),
                 b = as_array(motion_at(named[0], i / 64.0));
      for (std::size_t order = 0; order < 4; ++order) EXPECT_NEAR(a[order], b[order], 1e-13);
    }
    EXPECT_EQ(motion_at(found[0], 1.0).displacement, 4);
    EXPECT_EQ(motion_at(found[0], 1.0).acceleration, 0);
    conditions.push_back({0, 3, 0});
    conditions.push_back({1, 3, 0});
  }
}

TEST(PolynomialLaw, PlantedPolynomialsComeBack) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  int solved = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const std::size_t count = 3 + static_cast<std::size_t>(trial) % 10;
    Planted planted{std::vector<double>(count), 0.5 + std::abs(number(random))};
    for (std::size_t k = 1; k < count; ++k) planted.powers[k] = number(random);
    std::vector<MotionCondition> conditions;
    while (conditions.size() + 2 < count) {  // Hermite's: all lower derivatives at each place too
      const std::size_t i = conditions.size();
      const double at = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1.0 : 0.5;
      const int order = static_cast<int>(i / 3) + (i % 3 == 2 ? 0 : 1);
      conditions.push_back({at, order, planted(at, order)});
    }
    Pieces pieces;
    ASSERT_TRUE(append_pieces(polynomial_segment(planted.over, planted(1, 0), conditions), 0, 0, 0,
                              pieces));
    EXPECT_EQ(pieces[0].terms, static_cast<int>(count));
    expect_planted_motion(pieces, planted, 1e-9);
    ++solved;
  }
  EXPECT_EQ(solved, 400);
}

TEST(PolynomialLaw, AsManyConditionsAsAPieceHoldsTerms) {
  std::vector<MotionCondition> flat, both;
  for (int order = 1; order <= 14; ++order) flat.push_back({0, order, 0});
  Pieces pieces;
  ASSERT_TRUE(append_pieces(polynomial_segment(1, 1, flat), 0, 0, 0, pieces));
  for (const double t : {0.25, 0.5, 0.75}) {
    EXPECT_NEAR(motion_at(pieces[0], t).displacement, std::pow(t, 15), 1e-12);
  }
  for (int order = 1; order <= 7; ++order) {
    both.push_back({0, order, 0});
    both.push_back({1, order, 0});
  }
  ASSERT_TRUE(append_pieces(polynomial_segment(1, 1, both), 0, 0, 0, pieces));
  // Its velocity is that of u⁷(1 − u)⁷ · 15!/(7!)².
  EXPECT_NEAR(motion_at(pieces[1], 0.5).velocity, 51480.0 / 16384, 1e-11);
  both.push_back({0.5, 0, 0.5});
  EXPECT_FALSE(append_pieces(polynomial_segment(1, 1, both), 0, 0, 0, pieces));
}

TEST(PolynomialLaw, WhatHasNoSolutionOrManyIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Pieces pieces;
  const auto is_met = [&](std::vector<MotionCondition> conditions) {
    return append_pieces(polynomial_segment(1, 1, std::move(conditions)), 0, 0, 0, pieces);
  };
  EXPECT_FALSE(is_met({{0.5, 1, 1}}));          // the slope of a chord, for any parabola
  EXPECT_FALSE(is_met({{0.5 + 1e-14, 1, 1}}));  // and nearly so
  EXPECT_FALSE(is_met({{0.3, 3, 0}, {0.6, 3, 0}, {0.2, 3, 0}, {0.4, 3, 1}}));
  EXPECT_FALSE(is_met({{0.5, 1, 1}, {0.5, 1, 1}}));
  EXPECT_FALSE(is_met({{0.5, 9, 1}}));
  EXPECT_FALSE(is_met({{0.5, std::numeric_limits<int>::max(), 0}}));
  EXPECT_FALSE(is_met({{0.5, -1, 1}}));
  EXPECT_FALSE(is_met({{1.5, 0, 1}}));
  EXPECT_FALSE(is_met({{nan, 0, 1}}));
  EXPECT_FALSE(is_met({{0.25, 0, nan}}));
  EXPECT_TRUE(pieces.empty());
  EXPECT_TRUE(is_met({}));
  EXPECT_EQ(motion_at(pieces[0], 0.25).velocity, 1);
  EXPECT_TRUE(is_met({{1, 0, 0.5}, {0, 0, 2}}));  // in place of what is implied
  EXPECT_EQ(motion_at(pieces[1], 0.0).displacement, 2);
  EXPECT_EQ(motion_at(pieces[1], 1.0).displacement, 0.5);
}

MotionSegment spline_segment(double over, double rise, int degree) {
  MotionSegment segment;
  segment.law = MotionLaw::spline;
  segment.over = over;
  segment.rise = rise;
  segment.degree = degree;
  return segment;
}

/// Shares in order, strictly inside.
std::vector<double> random_shares(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> share(0.01, 0.99);
  std::vector<double> shares(static_cast<std::size_t>(count));
  for (double& at : shares) at = share(random);
  std::ranges::sort(shares);
  const auto repeated = std::ranges::unique(shares);
  shares.erase(repeated.begin(), repeated.end());
  return shares;
}

TEST(SplineLaw, APolynomialOfTheSplinesDegreeComesBack) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    const int degree = trial % 2 == 0 ? 3 : 5;
    Planted planted{{0}, 0.5 + std::abs(number(random))};
    for (int k = 1; k <= degree; ++k) planted.powers.push_back(number(random));
    MotionSegment segment = spline_segment(planted.over, planted(1, 0), degree);
    for (const double at : random_shares(random, trial % 7)) {
      segment.points.push_back({at, planted(at, 0)});
    }
    segment.ends = {planted(0, 1), planted(1, 1), planted(0, 2), planted(1, 2)};
    Pieces pieces;
    ASSERT_TRUE(append_pieces(segment, 0, 0, 0, pieces));
    EXPECT_EQ(pieces.size(), segment.points.size() + 1);
    double least = 1;
    for (const auto& piece : pieces) least = std::min(least, piece.span / planted.over);
    expect_planted_motion(pieces, planted, 1e-13 / std::pow(least, 3));
  }
}

/// How far the derivative `order` goes from the end of `before` to the begin of `after`; the fourth
/// by differences of the jerk, which is a parabola.
double gap(const MotionPiece<double>& before, const MotionPiece<double>& after, int order) {
  if (order < 4) {
    const auto k = static_cast<std::size_t>(order);
    return std::abs(as_array(motion_at(after, 0.0))[k] - as_array(motion_at(before, 1.0))[k]);
  }
  const auto slope = [](const MotionPiece<double>& piece, double t) {
    const auto jerk = [&](double at) { return motion_at(piece, at).jerk; };
    return (jerk(t + 0.5) - jerk(t - 0.5)) / piece.span;
  };
  return std::abs(slope(after, 0) - slope(before, 1));
}

TEST(SplineLaw, DerivativesAreContinuousAndAPeriodicOneClosesOnItself) {
  int tested = 0;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 40; ++trial) {
    for (const int degree : {3, 5}) {
      MotionSegment segment = spline_segment(2, 0, degree);
      segment.ends.periodic = trial % 2 == 0;
      if (!segment.ends.periodic) segment.ends.velocity_begin = 1;
      const int count = 1 + trial % 12;
      for (int i = 1; i <= count; ++i) {
        segment.points.push_back({(i + 0.3 * number(random)) / (count + 1), number(random)});
      }
      Pieces pieces;
      ASSERT_TRUE(append_pieces(segment, 0.25, 1, 0, pieces));
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (i + 1 == pieces.size() && !segment.ends.periodic) continue;
        for (int order = 0; order < degree; ++order) {
          EXPECT_LT(gap(pieces[i], pieces[(i + 1) % pieces.size()], order),
                    1e-12 * std::pow(4.0 * (count + 1), order))
              << trial << ' ' << i << ' ' << order;
        }
        if (i == 0) continue;
        ++tested;
        EXPECT_NEAR(motion_at(pieces[i], 0.0).displacement, 1 + segment.points[i - 1].displacement,
                    1e-14);
      }
      if (segment.ends.periodic) continue;
      ++tested;
      EXPECT_NEAR(motion_at(pieces.front(), 0.0).velocity, 1, 1e-14);
      EXPECT_NEAR(motion_at(pieces.back(), 1.0).velocity, 0, 1e-13);
    }
  }
  EXPECT_GE(tested, 430);
}

/// Interpolation of a smooth function: the error falls with the fourth power of the distance of the
/// knots for cubics, with the sixth for quintics.
TEST(SplineLaw, ErrorsFallWithTheOrderOfTheSpline) {
  const double turn = 2 * std::acos(-1.0);
  const auto error = [&](int degree, int count) {
    MotionSegment segment = spline_segment(turn, 0, degree);
    segment.ends.periodic = true;
    for (int i = 1; i < count; ++i) {
      const double at = static_cast<double>(i) / count;
      segment.points.push_back({at, 1 - std::cos(turn * at)});
    }
    Pieces pieces;
    EXPECT_TRUE(append_pieces(segment, 0, 0, 0, pieces));
    double greatest = 0;
    for (const auto& piece : pieces) {
      const double exact = 1 - std::cos(piece.begin + 0.5 * piece.span);
      greatest = std::max(greatest, std::abs(motion_at(piece, 0.5).displacement - exact));
    }
    return greatest;
  };
  EXPECT_NEAR(std::log2(error(3, 32) / error(3, 64)), 4, 0.1);
  EXPECT_NEAR(std::log2(error(5, 32) / error(5, 64)), 6, 0.1);
}

TEST(SplineLaw, ManyPoints) {
  constexpr int kCount = 100'000;
  for (const int degree : {3, 5}) {
    MotionSegment segment = spline_segment(6, 0, degree);
    segment.ends.periodic = true;
    for (int i = 1; i < kCount; ++i) {
      const double at = static_cast<double>(i) / kCount;
      segment.points.push_back({at, 1 - std::cos(2 * std::acos(-1.0) * at)});
    }
    Pieces pieces;
    ASSERT_TRUE(append_pieces(segment, 0, 0, 0, pieces));
    ASSERT_EQ(pieces.size(), static_cast<std::size_t>(kCount));
    const double w = 2 * std::acos(-1.0) / 6;
    EXPECT_NEAR(motion_at(pieces[kCount / 4], 0.0).velocity, w, 1e-10);
    EXPECT_NEAR(motion_at(pieces[kCount / 2], 0.0).acceleration, -w * w, 1e-4);
  }
}

TEST(SplineLaw, PointsOutOfOrderAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Pieces pieces;
  const auto fits = [&](std::vector<SplinePoint> points, int degree, double rise, bool periodic) {
    MotionSegment segment = spline_segment(1, rise, degree);
    segment.points = std::move(points);
    segment.ends.periodic = periodic;
    return append_pieces(segment, 0, 0, 0, pieces);
  };
  EXPECT_FALSE(fits({{0.5, 1}, {0.5, 1}}, 5, 1, false));
  EXPECT_FALSE(fits({{0.5, 1}, {0.4, 1}}, 3, 1, false));
  EXPECT_FALSE(fits({{0, 1}}, 5, 1, false));
  EXPECT_FALSE(fits({{1, 1}}, 5, 1, false));
  EXPECT_FALSE(fits({{nan, 1}}, 5, 1, false));
  EXPECT_FALSE(fits({{0.5, nan}}, 5, 1, false));
  EXPECT_FALSE(fits({{0.5, 1}}, 4, 1, false));
  EXPECT_FALSE(fits({{0.5, 1}}, 5, 1, true));
  EXPECT_FALSE(fits({{1e-300, 1}, {0.5, 1}}, 5, 1, false));  // too near to be distinguished
  EXPECT_TRUE(pieces.empty());
  EXPECT_TRUE(fits({}, 5, 1, false));  // 3-4-5
  EXPECT_NEAR(motion_at(pieces[0], 0.5).velocity, 1.875, 1e-14);
  EXPECT_TRUE(fits({}, 3, 0, true));
  EXPECT_EQ(motion_at(pieces[1], 0.5).velocity, 0);
}

/// The velocity's integral over each piece is its rise, by Gauss' quadrature.
TEST(SplineLaw, VelocitiesIntegrateToDisplacements) {
  MotionSegment segment = spline_segment(2, 1.5, 5);
  segment.points = {{0.2, 0.7}, {0.5, -0.3}, {0.9, 1.2}};
  Pieces pieces;
  ASSERT_TRUE(append_pieces(segment, 0, 0, 0, pieces));
  for (const auto& piece : pieces) {
    const double integral =
        piece.span * boost::math::quadrature::gauss<double, 7>::integrate(
                         [&](double t) { return motion_at(piece, t).velocity; }, 0.0, 1.0);
    EXPECT_NEAR(integral, motion_at(piece, 1.0).displacement - motion_at(piece, 0.0).displacement,
                1e-14);
  }
}

}  // namespace
}  // namespace cognate::cam::interpolating_law_test
