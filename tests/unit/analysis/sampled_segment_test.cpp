/// Straight stretches of sampled curves, held against all pairs of ends and all directions of a
/// strip that two samples give, and against the curve itself.
#include "analysis/coupler_curve/sampled_segment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "analysis/coupler_curve/circuit_samples.hpp"
#include "analysis/coupler_curve/closed_segment.hpp"
#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::sampled_segment_test {
namespace {

/// The narrowest strip has a side through two of the points.
struct Plain {
  double length = 0, deviation = std::numeric_limits<double>::infinity();
};
Plain plain_segment(const std::vector<Vec2d>& points) {
  Plain best;
  for (const Vec2d& a : points) {
    for (const Vec2d& b : points) {
      const double size = norm(b - a);
      if (size == 0) continue;
      const Vec2d along = (1 / size) * (b - a);
      const double half = half_width_across(points, along);
      if (half < best.deviation) {
        best = {std::abs(dot(along, points.back() - points.front())), half};
      }
    }
  }
  return best;
}

template <class Visit>
void for_each_segment(const std::vector<Vec2d>& curve, bool closed, const SegmentLimits& cells,
                      Visit visit) {
  const std::size_t n = curve.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Vec2d> points{curve[i]};
    for (std::size_t k = 1; k < n && k <= cells.most_cells; ++k) {
      if (!closed && i + k >= n) break;
      points.push_back(curve[(i + k) % n]);
      if (std::isnan(points.front().x) || std::isnan(points.back().x)) break;
      if (k >= cells.least_cells) visit(plain_segment(points));
    }
  }
}

std::vector<Vec2d> wavy_curve(std::mt19937_64& random, std::size_t count) {
  std::normal_distribution<double> place;
  const Vec2d a{place(random), place(random)}, b{place(random), place(random)};
  std::vector<Vec2d> curve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double q = kTurn * double(i) / double(count);
    curve[i] = {2 * std::cos(q) + a.x * std::cos(2 * q) + 0.2 * b.x * std::sin(3 * q),
                0.3 * std::sin(q) + 0.3 * a.y * std::sin(2 * q) + 0.2 * b.y * std::cos(2 * q)};
  }
  return curve;
}

TEST(SampledSegments, FindTheLongestOfAllPairs) {
  std::mt19937_64 random(7);
  SampledSegments segments;
  for (int i = 0; i < 60; ++i) {
    const bool closed = i % 2 == 0;
    std::vector<Vec2d> curve = wavy_curve(random, 18);
    if (i % 3 == 0) curve[random() % curve.size()] = {kNaN, kNaN};
    const SegmentLimits cells{1 + random() % 3, 6 + random() % 14};
    for (const double relative : {0.003, 0.03, 0.2}) {
      double longest = 0;
      for_each_segment(curve, closed, cells, [&](const Plain& all) {
        const bool straight = all.deviation <= relative * all.length;
        if (straight) longest = std::max(longest, all.length);
      });
      const SampledSegment found = segments.longest(curve, closed, relative, cells);
      EXPECT_NEAR(found.length, longest, 1e-9) << i << " at " << relative;
      EXPECT_LE(found.deviation, relative * found.length);
    }
  }
}

TEST(SampledSegments, FindTheStraightestOfAllPairs) {
  std::mt19937_64 random(8);
  SampledSegments segments;
  for (int i = 0; i < 60; ++i) {
    const bool closed = i % 2 == 0;
    const std::vector<Vec2d> curve = wavy_curve(random, 18);
    const SegmentLimits cells{2, 12};
    for (const double length : {0.5, 1.5, 3.0}) {
      double least = std::numeric_limits<double>::infinity();
      for_each_segment(curve, closed, cells, [&](const Plain& all) {
        if (all.length >= length) least = std::min(least, all.deviation / all.length);
      });
      const SampledSegment found = segments.straightest(curve, closed, length, 1e300, cells);
      if (std::isinf(least)) {
        EXPECT_EQ(found.length, 0);
        continue;
      }
      EXPECT_GE(found.length, length);
      EXPECT_NEAR(found.deviation / found.length, least, 1e-9) << i << " of " << length;
    }
  }
}

TEST(SampledSegments, NameTheEndsAcrossTheSeam) {
  // A long flat side that begins at sample 30 of 40 and ends at sample 9 of the next round.
  std::vector<Vec2d> curve(40);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double q = (double(i) + 10) / 20;  // 0…2 from sample 30
    const double x = std::fmod(q, 2.0);
    const double round = kPi * (x - 1);
    curve[i] = x < 1 ? Vec2d{10 * x, 0} : Vec2d{5 + 5 * std::cos(round), 4 + 3 * std::sin(round)};
  }
  SampledSegments segments;
  const SampledSegment found = segments.longest(curve, true, 1e-6);
  EXPECT_EQ(found.from, 30u);
  EXPECT_EQ(found.to, 49u);
  EXPECT_NEAR(found.length, 9.5, 1e-12);
  EXPECT_NEAR(found.direction.x, 1, 1e-12);
}

TEST(SampledSegments, OfFewSamples) {
  SampledSegments segments;
  const std::vector<Vec2d> none, one{{1, 2}}, same(5, Vec2d{1, 2}), nan(5, Vec2d{kNaN, kNaN});
  for (const auto* curve : {&none, &one, &same, &nan}) {
    for (const bool closed : {false, true}) {
      EXPECT_EQ(segments.longest(*curve, closed, 0.1).length, 0);
      EXPECT_EQ(segments.straightest(*curve, closed, 0.1, 1.0).length, 0);
    }
  }
}

/// Of Hoeken's linkage, the samples' longest stretch is the curve's own but for a step.
TEST(SampledSegments, AgreeWithTheCurveItself) {
  const FourBar hoeken{{0, 0}, {2.2, 0}, 1, 2.8, 2.8, Assembly::open, Vec2d{5.6, 0}};
  const Path path = path_of(as_mechanism(hoeken), {2, *hoeken.coupler_point});
  constexpr std::size_t kSamples = 360;
  std::vector<Vec2d> curve(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) curve[i] = path(kTurn * double(i) / kSamples).at;
  SampledSegments segments;
  const SampledSegment found = segments.longest(curve, true, 1e-3);
  const auto forward = forward_interval(path, kPi, {-10, 10});
  ASSERT_TRUE(forward);
  const StraightSegment whole = longest_segment(path, kPi, *forward, 1e-3);
  EXPECT_LE(found.length, whole.length * (1 + 1e-9));
  EXPECT_GT(found.length, whole.length * (1 - 0.01));
}

/// A chord over the angle 2x has δ/L = tan(x/2)/4.
TEST(ClosedSegmentFinder, OfCirclesEndsBetweenSamples) {
  const CycleTable turn(256);
  ClosedSegmentFinder finder;
  for (const double relative : {3e-4, 1e-3, 3e-3, 1e-2, 3e-2}) {
    for (const double radius : {1e-3, 7.0}) {
      CurveRoom circle;
      circle.resize(256);
      for (std::size_t i = 0; i < 256; ++i) {
        circle.x[i] = 5 + radius * turn.cos[i], circle.dx[i] = -radius * turn.sin[i];
        circle.y[i] = radius * turn.sin[i], circle.dy[i] = radius * turn.cos[i];
      }
      const double exact = 2 * radius * std::sin(2 * std::atan(4 * relative));
      const double found = finder(circle.samples(), relative);
      EXPECT_GT(found, 0.8 * exact) << relative;
      EXPECT_LT(found, 1.03 * exact) << relative;
    }
  }
}

TEST(ClosedSegmentFinder, AgreesWithTheCurveItself) {
  const FourBar hoeken{{0, 0}, {2.2, 0}, 1, 2.8, 2.8, Assembly::open, Vec2d{5.6, 0}};
  const Path path = path_of(as_mechanism(hoeken), {2, *hoeken.coupler_point});
  const auto forward = forward_interval(path, kPi, {-10, 10});
  ASSERT_TRUE(forward);
  CurveRoom curve;
  sample_circuit(hoeken, {}, CycleTable(256), curve);
  ClosedSegmentFinder finder;
  for (const double relative : {1e-3, 1e-2}) {
    const StraightSegment whole = longest_segment(path, kPi, *forward, relative);
    const double found = finder(curve.samples(), relative);
    EXPECT_LE(found, whole.length * 1.001) << relative;
    EXPECT_GT(found, whole.length * (1 - 0.01)) << relative;
  }
}

/// Against all pairs of many more samples, of random crank-rockers and double-cranks; theirs end at
/// a sample, as much as a step short at either end.
TEST(ClosedSegmentFinder, FindsTheLongestOfRandomCurves) {
  int tested = 0;
  std::mt19937_64 random(3);
  const auto draw = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  ClosedSegmentFinder finder;
  SampledSegments segments;
  for (int drawn = 0; drawn < 25;) {
    const FourBar linkage{{0, 0},
                          {draw(1.5, 5.5), 0},
                          1,
                          draw(1.5, 5.5),
                          draw(1.5, 5.5),
                          Assembly::open,
                          Vec2d{draw(-2, 5), draw(-3, 3)}};
    if (!can_assemble(lengths(linkage)) || !crank_rotates(lengths(linkage))) continue;
    ++tested;
    ++drawn;
    CurveRoom dense, curve;
    sample_circuit(linkage, {}, CycleTable(2048), dense);
    std::vector<Vec2d> points;
    for (std::size_t i = 0; i < dense.x.size(); ++i) points.push_back({dense.x[i], dense.y[i]});
    double step = norm(points.front() - points.back());
    for (std::size_t i = 1; i < points.size(); ++i) {
      step = std::max(step, norm(points[i] - points[i - 1]));
    }
    for (const double relative : {1e-3, 1e-2}) {
      sample_circuit(linkage, {}, CycleTable(samples_for_segments(relative)), curve);
      const double found = finder(curve.samples(), relative);
      const double longest = segments.longest(points, true, relative).length;
      EXPECT_GT(found, (relative < 5e-3 ? 0.88 : 0.96) * longest) << drawn;
      EXPECT_LT(found, 1.02 * longest + 2 * step) << drawn;
    }
  }
  EXPECT_GE(tested, 22);
}

}  // namespace
}  // namespace cognate::sampled_segment_test
