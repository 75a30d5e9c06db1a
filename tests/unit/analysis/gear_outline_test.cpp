/// Outlines of gears against the rack that cuts them, rolled as a solid.
#include <gtest/gtest.h>

#include "analysis/gear/fillet.hpp"
#include "analysis/gear/tooth_outline.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/rack_distance.hpp"

namespace cognate::gear_outline_test {
namespace {

using gear::OutlinePart;
using gear::OutlinePoint;
using gear::SpurGear;
using test::closest;

std::vector<SpurGear> gears() {
  return {
      {.teeth = 35, .module = 5},
      {.teeth = 9, .module = 10},
      {.teeth = 9, .module = 10, .profile_shift = 0.5},
      {.teeth = 5},
      {.teeth = 16, .profile_shift = -0.3},
      {.teeth = 60, .profile_shift = 1.1},
      {.teeth = 24, .module = 3, .coarsening = 0.2},
      {.teeth = 24, .rack = {14.5 * kDegree, 1, 0.157}},
      {.teeth = 30, .profile_shift = 0.2, .rack = {25 * kDegree, 1, 0.15}, .tip_reduction = 0.1},
      {.teeth = 12, .profile_shift = 0.9},
      {.teeth = 31, .rack = {20 * kDegree, 1, 0.4, 0.39}},  // ISO 53, D
      {.teeth = 14, .rack = {20 * kDegree, 1, 0.25, 0.25}},
      {.teeth = 20, .rack = {20 * kDegree, 1, 0.25, 0.45}},
      {.teeth = 40, .profile_shift = 0.3, .rack = {25 * kDegree, 1, 0.25, 0.0}},
      {.teeth = 200, .module = 0.5}};
}

double angle_from_tooth(const Vec2d& point) {
  return std::atan2(-point.x, point.y);
}

/// The angle at `radius` between the tooth's middle and its left involute, as textbooks have it.
double half_angle(const SpurGear& g, double radius) {
  const double alpha = g.rack.pressure_angle;
  const double there = std::acos(0.5 * g.module * g.teeth * std::cos(alpha) / radius);
  const double at_reference =
      (0.5 * kPi + 2 * g.profile_shift * std::tan(alpha) - g.coarsening / g.module) / g.teeth;
  return at_reference + std::tan(alpha) - alpha - std::tan(there) + there;
}

void expect_cut_by_rack(const SpurGear& g, double tolerance) {
  const auto half = tooth_half(g, tolerance * g.module);
  ASSERT_GT(half.size(), 5U) << g.teeth;
  for (const OutlinePoint& point : half) {
    const double distance = closest(g, point.at).distance;
    if (point.part == OutlinePart::tip) {
      EXPECT_GE(distance, -1e-9) << g.teeth << " " << g.profile_shift;
    } else {
      EXPECT_NEAR(distance, 0, 1e-9) << g.teeth << " " << g.profile_shift;
    }
    // The rack's tooth on the other side of the gear's tooth.
    EXPECT_GE(closest(g, -conj(point.at)).distance, -1e-9) << g.teeth << " " << g.profile_shift;
  }
}

TEST(GearOutline, TheRackTouchesEveryPointOfItAndCutsNone) {
  for (const SpurGear& g : gears()) expect_cut_by_rack(g, 1e-3);
}

TEST(GearOutline, TheRackTouchesEveryPointOfRandomGears) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  int undercut = 0;
  int made = 0;
  for (int i = 0; i < 250; ++i) {
    const SpurGear g{.teeth = std::floor(5 + 75 * share(random) * share(random)),
                     .profile_shift = -0.5 + 1.5 * share(random),
                     .rack = {(14 + 8 * share(random)) * kDegree, 0.7 + 0.4 * share(random),
                              0.05 + 0.2 * share(random)},
                     .coarsening = 0.05 * share(random)};
    if (tooth_fault(g) != gear::ToothFault::none) continue;
    expect_cut_by_rack(g, 0.02);
    undercut += is_undercut(g) ? 1 : 0;
    ++made;
  }
  EXPECT_GT(undercut, 40);
  EXPECT_GT(made - undercut, 40);
}

TEST(GearOutline, FlankIsTheInvolute) {
  int tested = 0;
  for (const SpurGear& g : gears()) {
    for (const OutlinePoint& point : tooth_half(g, 1e-3 * g.module)) {
      if (point.part != OutlinePart::involute) continue;
      ++tested;
      const double radius = norm(point.at);
      EXPECT_NEAR(angle_from_tooth(point.at), half_angle(g, radius), 1e-12) << g.teeth;
    }
  }
  EXPECT_GE(tested, 230);
}

TEST(GearOutline, NormalsMeetThePitchPointWhereTheRackTouches) {
  int tested = 0;
  for (const SpurGear& g : gears()) {
    const auto half = tooth_half(g, 1e-7 * g.module);
    for (std::size_t i = 1; i + 1 < half.size(); i += 7) {
      const OutlinePart part = half[i].part;
      if (half[i + 1].part != part || half[i - 1].part != part || part == OutlinePart::tip ||
          part == OutlinePart::root) {
        continue;
      }
      const double angle = closest(g, half[i].at).angle;
      const Vec2d turn{std::cos(angle), std::sin(angle)};
      const Vec2d pitch_point{0, 0.5 * g.module * g.teeth};
      const Vec2d tangent = turn * (half[i + 1].at - half[i - 1].at);
      const Vec2d normal = pitch_point - turn * half[i].at;
      if (norm(normal) < 0.05 * g.module) continue;
      ++tested;
      EXPECT_NEAR(dot(tangent, normal) / (norm(tangent) * norm(normal)), 0, 2e-3)
          << g.teeth << " at " << norm(half[i].at);
    }
  }
  EXPECT_GE(tested, 3800);
}

TEST(GearOutline, PartsFollowEachOtherOutwards) {
  for (const SpurGear& g : gears()) {
    const auto half = tooth_half(g, 1e-3 * g.module);
    EXPECT_NEAR(norm(half.front().at), root_radius(g), 1e-12 * g.module * g.teeth);
    EXPECT_NEAR(angle_from_tooth(half.front().at), kPi / g.teeth, 1e-12);
    EXPECT_EQ(half.back().at.x, 0);
    for (std::size_t i = 1; i < half.size(); ++i) {
      EXPECT_GE(half[i].part, half[i - 1].part);
      EXPECT_GE(norm(half[i].at), norm(half[i - 1].at) - 1e-12 * g.module * g.teeth);
      EXPECT_LE(half[i].at.x, 0);
      if (half[i].part == OutlinePart::involute && half[i - 1].part == OutlinePart::fillet) {
        EXPECT_NEAR(norm(half[i - 1].at), form_radius(g), 1e-11 * g.module * g.teeth);
      }
    }
  }
}

TEST(GearOutline, ChordsKeepTheTolerance) {
  const SpurGear g{.teeth = 9, .module = 10};
  const auto fine = tooth_half(g, 1e-6);
  for (const double tolerance : {0.3, 0.02, 1e-3}) {
    const auto coarse = tooth_half(g, tolerance);
    double worst = 0;
    for (const OutlinePoint& point : fine) {
      double nearest = g.module;
      for (std::size_t i = 1; i < coarse.size(); ++i) {
        const Vec2d from = coarse[i - 1].at;
        const Vec2d chord = coarse[i].at - from;
        const double share =
            std::clamp(dot(point.at - from, chord) / squared_norm(chord), 0.0, 1.0);
        nearest = std::min(nearest, norm(point.at - from - share * chord));
      }
      worst = std::max(worst, nearest);
    }
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, 0.05 * tolerance);  // and no finer than asked by far
  }
}

/// Li & Xu's program draws involutes from (z/2 − 1) m, where there is fillet, or nothing at all.
TEST(GearOutline, TheInvoluteDoesNotBeginAModuleBelowTheReferenceCircle) {
  const SpurGear g{.teeth = 35, .module = 5};
  const double claimed = (0.5 * g.teeth - 1) * g.module;
  EXPECT_LT(claimed, form_radius(g) - 1.1);
  const double angle = half_angle(g, claimed);
  const Vec2d claimed_point{-claimed * std::sin(angle), claimed * std::cos(angle)};
  EXPECT_GT(closest(g, claimed_point).distance, 0.01);  // material that no rack has touched
  for (int teeth = 5; teeth <= 40; ++teeth) {
    const SpurGear other{.teeth = static_cast<double>(teeth)};
    EXPECT_EQ(0.5 * teeth - 1 < base_radius(other), teeth <= 33) << teeth;
  }
}

double area(const std::vector<OutlinePoint>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    twice += cross(outline[i].at, outline[(i + 1) % outline.size()].at);
  }
  return 0.5 * twice;
}

TEST(GearOutline, TheWholeGearIsItsToothAllRound) {
  for (const SpurGear& g : gears()) {
    const auto half = tooth_half(g, 1e-4 * g.module);
    const auto outline = gear_outline(g, 1e-4 * g.module);
    const auto teeth = static_cast<std::size_t>(g.teeth);
    ASSERT_EQ(outline.size(), teeth * (2 * half.size() - 2));
    double half_area = 0;
    for (std::size_t i = 1; i < half.size(); ++i) {
      half_area += 0.5 * cross(half[i].at, half[i - 1].at);
    }
    EXPECT_NEAR(area(outline), 2 * g.teeth * half_area, 1e-9 * area(outline));
    // Chord by chord, each part is as often there as twice its number in the half.
    for (const auto part : {OutlinePart::fillet, OutlinePart::involute, OutlinePart::tip}) {
      const auto is_part = [&](const OutlinePoint& point) { return point.part == part; };
      EXPECT_EQ(std::ranges::count_if(outline, is_part),
                2 * static_cast<long>(teeth) * std::ranges::count_if(half, is_part));
    }
  }
}

TEST(GearOutline, TheRacksOutlineIsTheSolid) {
  for (const SpurGear& g : gears()) {
    const double angle = 0.3 / g.teeth;
    const auto outline = rack_outline(g, angle, 2, 1e-4 * g.module);
    ASSERT_FALSE(outline.empty());
    const double r = 0.5 * g.teeth;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      EXPECT_GE(outline[i].x, outline[i > 0 ? i - 1 : 0].x - 1e-9 * g.module);
      const double x = outline[i].x / g.module + r * angle;
      const double k = std::floor(x / kPi);
      const Vec2d from_tooth{x - (k + 0.5) * kPi, outline[i].y / g.module - r - g.profile_shift};
      EXPECT_NEAR(test::distance_from_tooth(g, from_tooth), 0, 1e-9) << g.teeth;
    }
  }
}

TEST(GearOutline, GearsThatCannotBeMadeHaveNone) {
  EXPECT_TRUE(gear::tooth_half({.teeth = 2}, 0.01).empty());
  EXPECT_TRUE(gear::gear_outline({.teeth = 2}, 0.01).empty());
  EXPECT_TRUE(gear::gear_outline({.teeth = 20}, 0).empty());
  EXPECT_TRUE(gear::gear_outline({.teeth = 20}, std::nan("")).empty());
  EXPECT_TRUE(gear::gear_outline({.teeth = std::nan("")}, 0.01).empty());
}

}  // namespace
}  // namespace cognate::gear_outline_test
