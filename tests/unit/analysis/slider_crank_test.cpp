/// What the dimensions of a slider-crank settle, held against published numbers and against its
/// motion in 113 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/quad_motion.hpp"

namespace cognate::slider_crank_test {

void PrintTo(const SliderCrank& m, std::ostream* out) {
  *out << std::hexfloat << "{{" << m.pivot.x << ", " << m.pivot.y << "}, " << m.crank << ", "
       << m.coupler << ", " << m.offset << ", {" << m.direction.x << ", " << m.direction.y
       << "}, sign " << sign(m.assembly) << "}";
}

namespace {

using test::Quad;
using test::QuadMotion;
using ::testing::PrintToString;
constexpr double pi = kPi;
constexpr double degree = pi / 180;

SliderCrank with(double crank, double coupler, double offset) {
  return {.pivot = {}, .crank = crank, .coupler = coupler, .offset = offset};
}

SliderCrank random_mechanism(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.1, 1.0), offset(-1.0, 1.0);
  return {test::random_point(random),
          length(random),
          length(random),
          random() % 4 == 0 ? 0.0 : offset(random),
          test::random_direction(random),
          random() % 2 == 0 ? Assembly::open : Assembly::crossed};
}

/// What the evaluator says of the slider.
struct Reference {
  double displacement, slope, pressure_angle;
};

std::optional<Reference> reference(const SliderCrank& m, double crank_angle) {
  const auto bodies = QuadMotion(as_mechanism(m), m.direction).at(crank_angle);
  if (!bodies) return std::nullopt;
  const Vec2<Quad> along = test::unit(m.direction);
  const auto& slider = (*bodies)[3];
  const double coupler = test::angle_between(along, (*bodies)[2].direction);
  // The coupler's lean, counted so that a crank above the line presses positively.
  const double lean =
      m.assembly == Assembly::open ? -coupler : coupler - std::copysign(pi, coupler);
  return Reference{static_cast<double>(dot(slider.origin[0] - test::quad(m.pivot), along)),
                   static_cast<double>(dot(slider.origin[1], along)), lean};
}

bool inside(const std::vector<CrankRange>& ranges, double angle) {
  return std::ranges::any_of(ranges, [&](const CrankRange& range) {
    const double turns = std::ceil((range.from - angle) / (2 * pi));
    return angle + 2 * pi * turns <= range.to;
  });
}

TEST(SliderCrank, HasThePublishedMotion) {
  // Li & Xu 2011, example 1-2, recomputed with 45 digits: coupler angle and slider displacement.
  const SliderCrank m = with(100, 300, 0);
  const std::array<std::array<double, 3>, 6> published{
      {{0, 0, 400},
       {30, -0.16744807921968932, 382.40652953342465},
       {70, -0.3185932086366148, 319.1051167804081},
       {137, -0.2293378769929345, 219.00976905611037},
       {200, 0.11425513783641354, 204.0747316800402},
       {290, 0.3185932086366148, 319.1051167804081}}};
  for (const auto& [angle, coupler, s] : published) {
    EXPECT_NEAR(*displacement(m, angle * degree), s, 1e-12 * s);
    EXPECT_NEAR(*pressure_angle(m, angle * degree), -coupler, 1e-15);
  }
  EXPECT_DOUBLE_EQ(*stroke(m), 200);
  EXPECT_DOUBLE_EQ(*time_ratio(m), 1);
  EXPECT_DOUBLE_EQ(pressure_angles(m)->steepest, std::asin(1.0 / 3));
}

TEST(SliderCrank, NamesItsClass) {
  EXPECT_EQ(name(mobility_class(with(1, 3, 1))), "rotating-crank");
  EXPECT_EQ(name(mobility_class(with(1, 3, -2.5))), "no-rotation");
  EXPECT_EQ(name(mobility_class(with(3, 1, -1))), "rotating-coupler");
  const FixedBlock pump{{}, 3, 1, 0, {0, 1}, Assembly::open};
  EXPECT_EQ(mobility_class(as_slider_crank(pump)), SliderCrankClass::rotating_coupler);
}

TEST(SliderCrank, ClosesWhereTheRangesSay) {
  int tested = 0;
  std::mt19937_64 random(41);
  std::array<int, 3> classes{};
  for (int i = 0; i < 150; ++i) {
    const SliderCrank m = random_mechanism(random);
    const auto ranges = crank_ranges(m);
    EXPECT_EQ(ranges.empty(), !can_assemble(m));
    EXPECT_EQ(crank_rotates(m),
              ranges.size() == 1 && ranges[0].to - ranges[0].from > 2 * pi - 1e-9);
    if (!ranges.empty()) ++classes[static_cast<std::size_t>(mobility_class(m))];
    for (int k = 0; k < 40; ++k) {
      const double angle = -4 + 8 * (k + 0.37) / 40;
      const auto expected = reference(m, angle);
      EXPECT_EQ(inside(ranges, angle), expected.has_value()) << PrintToString(m) << angle;
      const auto s = displacement(m, angle), alpha = pressure_angle(m, angle);
      ASSERT_EQ(s.has_value(), expected.has_value());
      if (!expected) continue;
      ++tested;
      EXPECT_NEAR(*s, expected->displacement, 1e-13) << PrintToString(m) << angle;
      EXPECT_NEAR(test::turn(*alpha, expected->pressure_angle), 0, 1e-13) << PrintToString(m);
    }
  }
  EXPECT_GT(std::ranges::min(classes), 20);
  EXPECT_GE(tested, 3100);
}

TEST(SliderCrank, DeadPointsEndTheRanges) {
  std::mt19937_64 random(42);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const SliderCrank m = random_mechanism(random);
    const auto points = dead_points(m);
    EXPECT_EQ(points.empty(), crank_rotates(m) || !can_assemble(m));
    for (const auto& [angle, s] : points) {
      const bool before = reference(m, angle - 1e-9).has_value();
      const bool after = reference(m, angle + 1e-9).has_value();
      EXPECT_NE(before, after) << PrintToString(m) << angle;
      EXPECT_NEAR(*displacement(m, angle), s, 1e-7) << PrintToString(m);
      EXPECT_NEAR(s, m.crank * std::cos(angle), 1e-13) << PrintToString(m);
      ++checked;
    }
  }
  EXPECT_GT(checked, 200);
}

TEST(SliderCrank, LimitsAreWhereTheSliderStands) {
  std::mt19937_64 random(43);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const SliderCrank m = random_mechanism(random);
    for (const auto& limit : {outer_limit(m), inner_limit(m)}) {
      if (!limit) continue;
      const auto there = reference(m, limit->crank_angle);
      ASSERT_TRUE(there) << PrintToString(m);
      EXPECT_NEAR(there->displacement, limit->displacement, 1e-12) << PrintToString(m);
      EXPECT_NEAR(there->slope, 0, 1e-10) << PrintToString(m);
      ++checked;
    }
  }
  EXPECT_GT(checked, 300);
}

TEST(SliderCrank, StrokeAndTimeRatioAreThoseOfTheSampledMotion) {
  std::mt19937_64 random(44);
  int checked = 0;
  for (int i = 0; i < 1000 && checked < 25; ++i) {
    const SliderCrank m = random_mechanism(random);
    EXPECT_EQ(time_ratio(m).has_value(), crank_rotates(m)) << PrintToString(m);
    if (!crank_rotates(m)) continue;
    ++checked;
    MechanismMotion<1> motion(as_mechanism(m));
    constexpr int samples = 10000;
    int advance = 0;
    double least = 1e9, greatest = -1e9;
    for (int k = 0; k < samples; ++k) {
      ASSERT_TRUE(motion.move_to(2 * pi * k / samples));
      const auto& slider = motion.bodies()[3];
      const double s = dot(slider.origin[0] - m.pivot, m.direction);
      least = std::min(least, s);
      greatest = std::max(greatest, s);
      advance += dot(slider.origin[1], m.direction) > 0;
    }
    EXPECT_NEAR(*stroke(m), greatest - least, 1e-6) << PrintToString(m);
    const double longer = std::max(advance, samples - advance);
    EXPECT_NEAR(*time_ratio(m), longer / (samples - longer), 2e-3) << PrintToString(m);
  }
  EXPECT_EQ(checked, 25);
}

TEST(SliderCrank, StrokesOfTheOtherClasses) {
  // A coupler that turns: the limits on one circuit are outer, open, and inner, crossed.
  SliderCrank pump = with(3, 1, 0.5);
  const double outer = outer_limit(pump)->displacement;
  pump.assembly = Assembly::crossed;
  EXPECT_DOUBLE_EQ(*stroke(pump), outer - inner_limit(pump)->displacement);
  // No link that turns: the slider passes from one outer limit to the other.
  EXPECT_DOUBLE_EQ(*stroke(with(1, 2, 1.5)), 2 * std::sqrt(9 - 2.25));
  EXPECT_DOUBLE_EQ(*stroke(with(1, 1, 0)), 2);
}

/// Against samples of s = l₁ cos θ ± √(l₂² − (l₁ sin θ − e)²), over parts of what the crank can do.
TEST(SliderCrank, StrokeOverAPartOfTheMotionIsThatOfItsSamples) {
  std::mt19937_64 random(46);
  std::uniform_real_distribution<double> share(0, 1);
  int turning = 0, other = 0;
  for (int i = 0; i < 3000; ++i) {
    const SliderCrank m = random_mechanism(random);
    const double side = m.assembly == Assembly::open ? 1 : -1;
    for (const CrankRange& all : crank_ranges(m)) {
      const double a = share(random), b = share(random), way = all.to - all.from;
      const double shift = 2 * pi * std::floor(3 * share(random) - 1);
      const CrankRange range{all.from + std::min(a, b) * way + shift,
                             all.from + std::max(a, b) * way + shift};
      double least = 1e9, greatest = -1e9;
      for (int k = 0; k <= 4000; ++k) {
        const double angle = range.from + (range.to - range.from) * k / 4000;
        const double across = m.crank * std::sin(angle) - m.offset;
        const double s = m.crank * std::cos(angle) +
                         side * std::sqrt(std::max(0.0, m.coupler * m.coupler - across * across));
        least = std::min(least, s);
        greatest = std::max(greatest, s);
      }
      const auto found = stroke(m, range);
      ASSERT_TRUE(found) << PrintToString(m);
      EXPECT_GE(*found, greatest - least - 1e-9 * m.crank) << PrintToString(m);
      EXPECT_LE(*found, greatest - least + 1e-4 * m.crank) << PrintToString(m);
      (crank_rotates(m) ? turning : other) += 1;
    }
  }
  EXPECT_GT(turning, 300);
  EXPECT_GT(other, 300);
}

TEST(SliderCrank, PressureAnglesAreTheExtremesOfTheSamples) {
  std::mt19937_64 random(45);
  std::uniform_real_distribution<double> unit(0, 1);
  int checked = 0;
  for (int i = 0; i < 150; ++i) {
    const SliderCrank m = random_mechanism(random);
    const auto ranges = crank_ranges(m);
    if (ranges.empty()) continue;
    const auto [from, to] = ranges[0];
    const CrankRange part{from + (to - from) * 0.4 * unit(random),
                          to - (to - from) * 0.4 * unit(random)};
    double least = pi, greatest = -pi;
    for (int k = 0; k <= 1000; ++k) {
      const double angle = *pressure_angle(m, part.from + (part.to - part.from) * k / 1000);
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
    }
    const auto of_part = pressure_angles(m, part), whole = pressure_angles(m);
    ASSERT_TRUE(of_part && whole);
    EXPECT_NEAR(of_part->min, least, 1e-3) << PrintToString(m);
    EXPECT_NEAR(of_part->max, greatest, 1e-3) << PrintToString(m);
    EXPECT_LE(of_part->min, least + 1e-14);
    EXPECT_GE(of_part->max, greatest - 1e-14);
    EXPECT_LE(whole->min, of_part->min + 1e-14);
    EXPECT_GE(whole->max, of_part->max - 1e-14);
    EXPECT_EQ(of_part->steepest, std::max(std::abs(of_part->min), std::abs(of_part->max)));
    ++checked;
  }
  EXPECT_GT(checked, 100);
}

TEST(SliderCrank, KeepsItsDigitsNearAChangePointAtAnyScale) {
  std::mt19937_64 random(46);
  std::uniform_real_distribution<double> unit(0.2, 1.0);
  for (int i = 0; i < 300; ++i) {
    const double gap = std::pow(10.0, -1 - i % 13);
    const double l1 = unit(random), e = unit(random);
    const double shorter = (l1 + e) * (1 - gap), longer = (l1 + e) * (1 + gap);
    // From −π/2, where a coupler that is too short begins to reach; and the lean of one that is
    // long enough, there.
    const Quad begins = acos((Quad(shorter) - Quad(e)) / Quad(l1));
    const Quad lean = asin((Quad(l1) + Quad(e)) / Quad(longer));
    for (const double scale : {1e-150, 1.0, 1e150}) {
      // Lengths times 10^±150 are rounded, by which the gap moves by ε relative to it.
      const double moved = scale == 1.0 ? 0 : 4e-16 / std::sqrt(gap);
      const auto ranges = crank_ranges(with(scale * l1, scale * shorter, scale * e));
      ASSERT_EQ(ranges.size(), 1);
      EXPECT_NEAR(ranges[0].from + pi / 2, static_cast<double>(begins), 1e-15 + moved);
      const auto angles = pressure_angles(with(scale * l1, scale * longer, scale * e));
      EXPECT_NEAR(angles->steepest, static_cast<double>(lean), 1e-15 + moved);
    }
  }
}

TEST(SliderCrank, KnowsItsChangePoints) {
  const SliderCrank offset = with(1, 3, 2);
  EXPECT_TRUE(is_change_point(offset) && crank_rotates(offset));
  const auto points = change_points(offset);
  ASSERT_EQ(points.size(), 1);
  EXPECT_EQ(points[0].crank_angle, -pi / 2);
  EXPECT_NEAR(*displacement(offset, -pi / 2), 0, 1e-7);
  EXPECT_EQ(change_points(with(3, 1, 2))[0].crank_angle, pi / 2);
  const SliderCrank centred = with(0.7, 0.7, 0);
  EXPECT_EQ(change_points(centred).size(), 2);
  EXPECT_FALSE(inner_limit(centred) || time_ratio(centred));
  EXPECT_FALSE(is_change_point(with(1, 3, 2.001)));
  EXPECT_TRUE(change_points(with(1, 3, 2.001)).empty());
}

TEST(SliderCrank, WhatCannotBeAssembledIsSaid) {
  const SliderCrank far = with(1, 2, -3.1);
  EXPECT_FALSE(can_assemble(far));
  EXPECT_TRUE(crank_ranges(far).empty() && dead_points(far).empty());
  EXPECT_FALSE(outer_limit(far) || inner_limit(far) || stroke(far) || time_ratio(far));
  EXPECT_FALSE(pressure_angles(far) || pressure_angle(far, 1) || displacement(far, -1));
  EXPECT_FALSE(pressure_angles(with(1, 2, 1.5), {0, 6}));
  EXPECT_TRUE(can_assemble(with(1, 2, 3)));
}

}  // namespace
}  // namespace cognate::slider_crank_test
