/// What the dimensions of a guide-bar settle, held against published numbers and against its motion
/// in 113 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar_mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/quad_motion.hpp"

namespace cognate::guide_bar_test {

void PrintTo(const GuideBar& m, std::ostream* out) {
  *out << std::hexfloat << "{{" << m.pivot_a.x << ", " << m.pivot_a.y << "}, {" << m.pivot_c.x
       << ", " << m.pivot_c.y << "}, " << m.crank << ", " << m.offset << ", sign "
       << sign(m.assembly) << "}";
}

namespace {

using test::Quad;
using test::QuadMotion;
using ::testing::PrintToString;
constexpr double pi = kPi;
constexpr double degree = pi / 180;

GuideBar with(double crank, double frame, double offset) {
  return {.pivot_a = {}, .pivot_c = {frame, 0}, .crank = crank, .offset = offset};
}

GuideBar random_mechanism(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.1, 1.5), offset(-0.7, 0.7);
  return {test::random_point(random), test::random_point(random), length(random),
          random() % 4 == 0 ? 0.0 : offset(random),
          random() % 2 == 0 ? Assembly::open : Assembly::crossed};
}

/// Body `bar` of the mechanism: its direction from A→C, and how that changes with the crank.
struct Reference {
  double angle, turn;
};

template <class M>
std::optional<Reference> reference(const M& m, double crank_angle, std::size_t body = 3) {
  const Vec2d frame = m.pivot_c - m.pivot_a;
  const auto bodies = QuadMotion(as_mechanism(m), frame).at(crank_angle);
  if (!bodies) return std::nullopt;
  const auto& bar = (*bodies)[body];
  return Reference{test::angle_between(test::quad(frame), bar.direction),
                   static_cast<double>(bar.turn[0])};
}

TEST(GuideBar, HasThePublishedMotion) {
  // Li & Xu 2011, example 1-3: guide pivot at the origin, crank pivot above it; the crank angle and
  // the bar's from the x axis.
  const GuideBar m{{0, 0.38}, {0, 0}, 0.12, 0, Assembly::open};
  const std::array<std::array<double, 2>, 4> published{{{0, 1.2649174553900444},
                                                        {70, 1.4876977720274969},
                                                        {200, 1.8919553284071466},
                                                        {290, 1.418406364197419}}};
  for (const auto& [angle, bar] : published) {
    // The frame A→C points down.
    EXPECT_NEAR(test::turn(*bar_angle(m, angle * degree + pi / 2) - pi / 2, bar), 0, 1e-15);
  }
  EXPECT_EQ(name(mobility_class(m)), "oscillating");
  EXPECT_EQ(*greatest_pressure_angle(m), 0);
}

TEST(GuideBar, HasThePublishedSwingAndTimeRatio) {
  // Li & Xu 2011, example 1-4: the guide of a shaper, crank 0.125 and frame 0.275.
  const GuideBar m = with(0.125, 0.275, 0);
  EXPECT_NEAR(*swing(m), 0.9437236745592837, 1e-15);
  EXPECT_NEAR(*time_ratio(m), 1.8587624499578357, 1e-14);
  // The crank positions there, in axes with the crank pivot above the guide pivot.
  const auto [left, right] = bar_limits(m);
  EXPECT_NEAR(test::turn(left->crank_angle, 3.613454490869435 + pi / 2), 0, 1e-14);
  EXPECT_NEAR(test::turn(right->crank_angle, 5.8113234698999445 + pi / 2), 0, 1e-14);
}

TEST(GuideBar, ClosesWhereTheRangesSay) {
  int tested = 0;
  std::mt19937_64 random(51);
  std::array<int, 3> classes{};
  for (int i = 0; i < 150; ++i) {
    const GuideBar m = random_mechanism(random);
    const auto ranges = crank_ranges(m);
    EXPECT_EQ(ranges.empty(), !can_assemble(m));
    if (!ranges.empty()) ++classes[static_cast<std::size_t>(mobility_class(m))];
    for (int k = 0; k < 40; ++k) {
      const double angle = 2 * pi * (k + 0.37) / 40;
      const auto expected = reference(m, angle);
      const bool inside = !ranges.empty() && ranges[0].from < angle && angle < ranges[0].to;
      EXPECT_EQ(inside, expected.has_value()) << PrintToString(m) << angle;
      const auto bar = bar_angle(m, angle);
      ASSERT_EQ(bar.has_value(), expected.has_value());
      if (!expected) continue;
      ++tested;
      EXPECT_NEAR(test::turn(*bar, expected->angle), 0, 1e-13) << PrintToString(m) << angle;
      // The pressure angle is that between B–C and the guide.
      const Vec2d frame = m.pivot_c - m.pivot_a;
      const Vec2d b = m.crank * Vec2d{std::cos(angle), std::sin(angle)};
      const Vec2d cb = b - Vec2d{std::hypot(frame.x, frame.y), 0};
      const double lean = std::atan2(cb.y, cb.x) - *bar;
      EXPECT_NEAR(std::abs(std::sin(lean)), std::sin(*pressure_angle(m, angle)), 1e-13);
    }
  }
  EXPECT_GT(std::ranges::min(classes), 20);
  EXPECT_GE(tested, 5200);
}

TEST(GuideBar, TheBarTurnsBackAtItsLimits) {
  std::mt19937_64 random(52);
  std::array<int, 3> limits{};
  for (int i = 0; i < 300; ++i) {
    const GuideBar m = random_mechanism(random);
    int found = 0;
    for (const auto& limit : bar_limits(m)) {
      if (!limit) continue;
      ++found;
      const auto there = reference(m, limit->crank_angle);
      ASSERT_TRUE(there) << PrintToString(m);
      EXPECT_NEAR(test::turn(limit->bar_angle, there->angle), 0, 1e-12) << PrintToString(m);
      EXPECT_NEAR(there->turn, 0, 1e-9) << PrintToString(m);
    }
    if (!can_assemble(m)) continue;
    limits[static_cast<std::size_t>(mobility_class(m))] += found;
    if (mobility_class(m) == GuideBarClass::oscillating) {
      EXPECT_EQ(found, 2);
      EXPECT_NEAR(*swing(m),
                  std::abs(test::turn(bar_limits(m)[0]->bar_angle, bar_limits(m)[1]->bar_angle)),
                  1e-13);
    }
  }
  EXPECT_GT(limits[0], 100);
  EXPECT_EQ(limits[1], 0);
  EXPECT_GT(limits[2], 10);
}

TEST(GuideBar, SwingAndTimeRatioAreThoseOfTheSampledMotion) {
  std::mt19937_64 random(53);
  int checked = 0;
  for (int i = 0; i < 1000 && checked < 25; ++i) {
    const GuideBar m = random_mechanism(random);
    const bool oscillates = can_assemble(m) && mobility_class(m) == GuideBarClass::oscillating;
    EXPECT_EQ(swing(m).has_value(), oscillates);
    if (!oscillates) continue;
    ++checked;
    MechanismMotion<1> motion(as_mechanism(m));
    constexpr int samples = 10000;
    int advance = 0;
    double angle = 0, least = 0, greatest = 0;
    for (int k = 0; k < samples; ++k) {
      ASSERT_TRUE(motion.move_to(2 * pi * k / samples));
      const double turn = motion.bodies()[3].turn[0];
      advance += turn > 0;
      angle += turn * 2 * pi / samples;
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
    }
    EXPECT_NEAR(*swing(m), greatest - least, 2e-3) << PrintToString(m);
    const double longer = std::max(advance, samples - advance);
    EXPECT_NEAR(*time_ratio(m) / (longer / (samples - longer)), 1, 2e-3) << PrintToString(m);
  }
  EXPECT_EQ(checked, 25);
}

TEST(GuideBar, HalfTurnsOfARotatingBarTakeTheCrankThisRatio) {
  std::mt19937_64 random(54);
  std::uniform_real_distribution<double> any(-3, 3);
  int checked = 0;
  for (int i = 0; i < 1000 && checked < 25; ++i) {
    const GuideBar m = random_mechanism(random);
    const bool rotates = can_assemble(m) && mobility_class(m) == GuideBarClass::rotating;
    const double start = any(random);
    EXPECT_EQ(half_turn_time_ratio(m, start).has_value(), rotates);
    if (!rotates) continue;
    ++checked;
    constexpr int samples = 10000;
    int first_half = 0;
    for (int k = 0; k < samples; ++k) {
      first_half += std::sin(*bar_angle(m, 2 * pi * k / samples) - start) > 0;
    }
    const double longer = std::max(first_half, samples - first_half);
    EXPECT_NEAR(*half_turn_time_ratio(m, start) / (longer / (samples - longer)), 1, 2e-3)
        << PrintToString(m);
    EXPECT_GE(*half_turn_time_ratio(m, pi / 2), *half_turn_time_ratio(m, start));
  }
  EXPECT_EQ(checked, 25);
  // Whitworth: cos of half the quicker angle is frame/crank.
  EXPECT_NEAR(*half_turn_time_ratio(with(2, 1, 0), pi / 2), 2, 1e-14);
}

TEST(GuideBar, TravelIsThatOfTheSampledBlock) {
  std::mt19937_64 random(55);
  int checked = 0;
  for (int i = 0; i < 100; ++i) {
    const GuideBar m = random_mechanism(random);
    if (!can_assemble(m)) continue;
    ++checked;
    const Vec2d frame = m.pivot_c - m.pivot_a;
    MechanismMotion<0> motion(as_mechanism(m));
    double nearest = 1e9, farthest = 0;
    for (int k = 0; k < 1000; ++k) {
      if (!motion.move_to(std::atan2(frame.y, frame.x) + 2 * pi * k / 1000)) continue;
      const auto bodies = motion.bodies();
      const double s = dot(bodies[3].direction, bodies[2].origin[0] - m.pivot_c);
      nearest = std::min(nearest, std::abs(s));
      farthest = std::max(farthest, std::abs(s));
    }
    const auto travel = block_travel(m);
    // At a dead point the block is at the foot of the perpendicular.
    EXPECT_NEAR(travel->nearest, crank_rotates(m) ? nearest : 0, 1e-13) << PrintToString(m);
    EXPECT_NEAR(travel->farthest, farthest, 1e-13) << PrintToString(m);
  }
  EXPECT_GT(checked, 80);
}

TEST(GuideBar, PressureAnglesAreTheGreatestOfTheSamples) {
  std::mt19937_64 random(58);
  std::uniform_real_distribution<double> share(0, 0.45);
  int checked = 0, inside = 0;
  for (int i = 0; i < 300; ++i) {
    const GuideBar m = random_mechanism(random);
    const auto ranges = crank_ranges(m);
    if (ranges.empty()) continue;
    ++checked;
    const double span = ranges[0].to - ranges[0].from;
    const double turned = crank_rotates(m) ? -pi : 2 * pi * (i % 3 - 1);
    const CrankRange part{ranges[0].from + share(random) * span + turned,
                          ranges[0].to - share(random) * span + turned};
    double greatest = 0;
    for (int k = 0; k <= 1000; ++k) {
      const double angle = part.from + (part.to - part.from) * k / 1000;
      greatest = std::max(greatest, *pressure_angle(m, angle));
    }
    const double of_part = *greatest_pressure_angle(m, part);
    EXPECT_NEAR(of_part, greatest, 1e-3) << PrintToString(m);
    EXPECT_GE(of_part, greatest - 1e-14) << PrintToString(m);
    EXPECT_GE(*greatest_pressure_angle(m), of_part - 1e-14) << PrintToString(m);
    const double at_ends = std::max(*pressure_angle(m, part.from), *pressure_angle(m, part.to));
    inside += of_part > at_ends;
  }
  EXPECT_GT(checked, 200);
  EXPECT_GT(inside, 50);
}

TEST(GuideBar, KeepsItsDigitsNearAChangePointAtAnyScale) {
  std::mt19937_64 random(56);
  std::uniform_real_distribution<double> unit(0.2, 1.0);
  for (int i = 0; i < 300; ++i) {
    const double gap = std::pow(10.0, -1 - i % 13);
    const double l1 = unit(random), e = unit(random), l4 = (l1 + e) * (1 - gap);
    const Quad a(l1), d(l4), o(e);
    const Quad begins = acos((a * a + d * d - o * o) / (2 * a * d));
    for (const double scale : {1e-150, 1.0, 1e150}) {
      const double moved = scale == 1.0 ? 0 : 4e-16 / std::sqrt(gap);
      const auto ranges = crank_ranges(with(scale * l1, scale * l4, scale * e));
      ASSERT_EQ(ranges.size(), 1);
      EXPECT_NEAR(ranges[0].from, static_cast<double>(begins), 1e-15 + moved) << l1 << ' ' << e;
    }
  }
}

TEST(GuideBar, KnowsItsChangePoints) {
  const GuideBar equal = with(1, 1, 0);
  EXPECT_TRUE(is_change_point(equal) && crank_rotates(equal));
  EXPECT_DOUBLE_EQ(*swing(equal), pi);
  EXPECT_FALSE(time_ratio(equal));    // one half turn of the bar in no time
  EXPECT_FALSE(bar_angle(equal, 0));  // pin on pivot: any direction
  // Elsewhere the bar turns half as much.
  EXPECT_NEAR(*bar_angle(equal, 1.2), pi / 2 + 0.6, 1e-15);
  EXPECT_TRUE(is_change_point(with(2, 3, -1)) && is_change_point(with(3, 2, 1)));
  EXPECT_FALSE(is_change_point(with(2, 3, 1.001)));
  EXPECT_NEAR(*greatest_pressure_angle(with(2, 3, -1)), pi / 2, 1e-15);
}

TEST(GuideBar, WhatCannotBeAssembledIsSaid) {
  const GuideBar far = with(1, 2, -3.1);
  EXPECT_FALSE(can_assemble(far) || crank_rotates(far));
  EXPECT_TRUE(crank_ranges(far).empty());
  EXPECT_FALSE(bar_limits(far)[0] || bar_limits(far)[1] || swing(far) || time_ratio(far));
  EXPECT_FALSE(bar_angle(far, 1) || block_travel(far) || pressure_angle(far, 1));
  EXPECT_FALSE(greatest_pressure_angle(far) || greatest_pressure_angle(far, {1, 2}));
}

TEST(OscillatingBlock, TurnsAsTheGuideBarDoes) {
  std::mt19937_64 random(57);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const GuideBar bar = random_mechanism(random);
    const OscillatingBlock block{bar.pivot_a, bar.pivot_c, bar.crank, bar.offset, bar.assembly};
    const double angle = 0.02 * i;
    const auto of_bar = reference(as_guide_bar(block), angle),
               of_block = reference(block, angle, 2);
    ASSERT_EQ(of_bar.has_value(), of_block.has_value());
    if (!of_bar) continue;
    ++checked;
    EXPECT_NEAR(std::abs(test::turn(of_bar->angle, of_block->angle)), pi, 1e-14);
    EXPECT_NEAR(of_bar->turn, of_block->turn, 1e-13 * std::abs(of_bar->turn));
  }
  EXPECT_GT(checked, 150);
}

}  // namespace
}  // namespace cognate::guide_bar_test
