/// Pairs of spur gears against their motion: points of the flanks followed while both gears turn.
#include <gtest/gtest.h>

#include <optional>

#include "analysis/gear/spur_pair.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"
#include "tests/support/count_allocations.hpp"

namespace cognate::gear_pair_test {
namespace {

using gear::PairGeometry;
using gear::SpurGear;
using gear::SpurPair;

std::vector<SpurPair> pairs() {
  return {
      {{SpurGear{.teeth = 20, .module = 5}, SpurGear{.teeth = 80, .module = 5}}, 250},
      {{SpurGear{.teeth = 20, .module = 5}, SpurGear{.teeth = 80, .module = 5}}, 255},
      {{SpurGear{.teeth = 18, .profile_shift = 0.5}, SpurGear{.teeth = 31, .profile_shift = 0.2}},
       25.2},
      {{SpurGear{.teeth = 40, .profile_shift = -0.3}, SpurGear{.teeth = 19, .profile_shift = 0.4}},
       29.7},
      {{SpurGear{.teeth = 12}, SpurGear{.teeth = 60}}, 36},
      {{SpurGear{.teeth = 9, .tip_reduction = 0.1}, SpurGear{.teeth = 9}}, 9.1},
      {{SpurGear{.teeth = 9, .profile_shift = 0.9}, SpurGear{.teeth = 25, .profile_shift = 0.5}},
       18.2}};
}

/// A point of a flank: the gear's centre at the origin, the tooth's middle on the y axis, the flank
/// on its left. The involute as textbooks have it, by the cosine of its pressure angle.
Vec2d flank_point(const SpurGear& g, double radius) {
  const double alpha = g.rack.pressure_angle;
  const double there = std::acos(0.5 * g.module * g.teeth * std::cos(alpha) / radius);
  const double angle =
      (0.5 * kPi + 2 * g.profile_shift * std::tan(alpha) - g.coarsening / g.module) / g.teeth +
      std::tan(alpha) - alpha - std::tan(there) + there;
  return {-radius * std::sin(angle), radius * std::cos(angle)};
}

/// The flank in mesh when its normal passes through the pitch point; the pinion's centre at the
/// origin, the wheel's at (0, a′).
struct Touch {
  double turn = 0;  ///< of the pinion, counter-clockwise
  Vec2d at{};       ///< the point of contact
  Vec2d tangent{};  ///< of the flanks
  double other_radius = 0;
};

Touch touch(const SpurPair& pair, double radius) {
  const SpurGear& g = pair.gears[0];
  const double step = 1e-5 * radius;
  const Vec2d point = flank_point(g, radius);
  const Vec2d along = flank_point(g, radius + step) - flank_point(g, radius - step);
  const Vec2d tangent = (1 / norm(along)) * along;
  // The pitch point seen from the turned gear is at distance r_w on the normal: on the left.
  const double pitch = pair.centre_distance * g.teeth / (g.teeth + pair.gears[1].teeth);
  const double across = dot(point, tangent);
  const Vec2d foot = across * tangent;
  const Vec2d normal = perp(tangent);
  Vec2d seen = foot + std::sqrt(pitch * pitch - across * across) * normal;
  if (seen.y < 0) seen = foot - std::sqrt(pitch * pitch - across * across) * normal;
  const double turn = std::atan2(seen.x, seen.y);
  const Vec2d turned{std::cos(turn), std::sin(turn)};
  const Vec2d at = turned * point;
  return {turn, at, turned * tangent, norm(Vec2d{0, pair.centre_distance} - at)};
}

double own_end(const SpurGear& g) {
  return flank_end_radius(g);
}

/// Radii of the pinion's flank that touch the wheel's, by trying many.
std::optional<std::array<double, 2>> touching(const SpurPair& pair) {
  const double from = form_radius(pair.gears[0]) * (1 + 1e-9);
  const double to = own_end(pair.gears[0]);
  const auto on_wheel = [&](double radius) {
    const double other = touch(pair, radius).other_radius;
    return other >= form_radius(pair.gears[1]) && other <= own_end(pair.gears[1]);
  };
  constexpr int kSteps = 2000;
  std::optional<std::array<double, 2>> range;
  for (int i = 0; i <= kSteps; ++i) {
    const double radius = from + (to - from) * i / kSteps;
    if (!on_wheel(radius)) continue;
    if (!range) range = {radius, radius};
    (*range)[1] = radius;
  }
  // The ends between the last that do and the first that don't.
  const double step = (to - from) / kSteps;
  for (int end = 0; range && end < 2; ++end) {
    double inside = (*range)[end];
    double outside = std::clamp(inside + (end == 0 ? -step : step), from, to);
    for (int i = 0; i < 60 && !on_wheel(outside); ++i) {
      const double middle = 0.5 * (inside + outside);
      (on_wheel(middle) ? inside : outside) = middle;
    }
    (*range)[end] = on_wheel(outside) ? outside : inside;
  }
  return range;
}

TEST(SpurPair, ContactRatioIsTheTurnOfAToothInContactOverThePitch) {
  for (const SpurPair& pair : pairs()) {
    const PairGeometry result = geometry(pair);
    const auto radii = touching(pair);
    ASSERT_TRUE(radii);
    const double turn = touch(pair, (*radii)[1]).turn - touch(pair, (*radii)[0]).turn;
    const double pitch = kTurn / pair.gears[0].teeth;
    EXPECT_NEAR(result.contact_ratio, turn / pitch, 2e-7) << pair.centre_distance;
    EXPECT_NEAR(result.gears[0].contact_start, (*radii)[0], 1e-7 * (*radii)[0]);
    EXPECT_NEAR(result.gears[0].contact_end, (*radii)[1], 1e-7 * (*radii)[1]);
    const Touch first = touch(pair, (*radii)[0]);
    const Touch last = touch(pair, (*radii)[1]);
    EXPECT_NEAR(result.gears[1].contact_end, first.other_radius, 1e-7 * first.other_radius);
    EXPECT_NEAR(result.gears[1].contact_start, last.other_radius, 1e-7 * last.other_radius);
    EXPECT_NEAR(result.path_length, norm(last.at - first.at), 1e-6 * pair.centre_distance);
  }
}

/// Velocities of the two points that touch, the pinion turning by 1.
std::array<Vec2d, 2> velocities(const SpurPair& pair, const Vec2d& at) {
  const double ratio = pair.gears[0].teeth / pair.gears[1].teeth;
  return {perp(at), -ratio * perp(at - Vec2d{0, pair.centre_distance})};
}

TEST(SpurPair, SlidingIsThatOfTheTouchingPoints) {
  for (const SpurPair& pair : pairs()) {
    const PairGeometry result = geometry(pair);
    const double pitch_speed = result.gears[0].working_radius;
    double greatest = 0;
    const auto sliding = [&](double radius, int own) {
      const Touch contact = touch(pair, radius);
      const auto v = velocities(pair, contact.at);
      greatest = std::max(greatest, norm(v[0] - v[1]) / pitch_speed);
      // Along the normal they are the same: the flanks stay in touch.
      EXPECT_NEAR(cross(v[0] - v[1], contact.tangent), 0, 1e-6 * pitch_speed);
      return 1 - dot(v[1 - own], contact.tangent) / dot(v[own], contact.tangent);
    };
    const auto& [pinion, wheel] = result.gears;
    const auto near = [](double value) { return 1e-5 * std::max(1.0, value * value); };
    EXPECT_NEAR(sliding(pinion.contact_end, 0), pinion.sliding_end, near(pinion.sliding_end));
    EXPECT_NEAR(sliding(pinion.contact_end, 1), wheel.sliding_start, near(wheel.sliding_start));
    if (pinion.sliding_start > -100) {
      EXPECT_NEAR(sliding(pinion.contact_start, 0), pinion.sliding_start,
                  near(pinion.sliding_start));
      EXPECT_NEAR(sliding(pinion.contact_start, 1), wheel.sliding_end, near(wheel.sliding_end));
      EXPECT_NEAR(result.greatest_sliding_speed, greatest, 1e-6);
    }
  }
}

TEST(SpurPair, BacklashIsWhatTheTeethLeaveOfThePitch) {
  for (SpurPair pair : pairs()) {
    pair.gears[0].coarsening = 0.03;
    pair.gears[1].coarsening = 0.01;
    const PairGeometry result = geometry(pair);
    const auto& [pinion, wheel] = result.gears;
    const double pitch = kTurn * pinion.working_radius / pair.gears[0].teeth;
    const double left = pitch - tooth_thickness(pair.gears[0], pinion.working_radius) -
                        tooth_thickness(pair.gears[1], wheel.working_radius);
    EXPECT_NEAR(result.backlash, left, 1e-12 * pair.centre_distance);
    EXPECT_DOUBLE_EQ(result.normal_backlash,
                     result.backlash * std::cos(result.working_pressure_angle));
    EXPECT_DOUBLE_EQ(pinion.working_radius + wheel.working_radius, pair.centre_distance);
  }
}

TEST(SpurPair, NoBacklashIsNothingRatherThanRounding) {
  for (int teeth = 10; teeth < 60; ++teeth) {
    const SpurPair pair{{SpurGear{.teeth = 20}, SpurGear{.teeth = static_cast<double>(teeth)}},
                        10 + 0.5 * teeth};
    EXPECT_EQ(geometry(pair).backlash, 0);
  }
}

TEST(SpurPair, CentreDistanceAndShiftsAreInverse) {
  int tested = 0;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 500; ++i) {
    SpurPair pair;
    for (SpurGear& g : pair.gears) {
      g.teeth = std::floor(8 + 60 * share(random));
      g.module = 2.5;
      g.profile_shift = -0.4 + share(random);
      g.coarsening = 0.1 * share(random);
    }
    const double shifts = pair.gears[0].profile_shift + pair.gears[1].profile_shift;
    const double play = i % 2 == 0 ? 0 : share(random);
    pair.centre_distance = centre_distance_with_backlash(pair.gears, play);
    if (std::isnan(pair.centre_distance)) continue;
    ++tested;
    EXPECT_NEAR(geometry(pair).backlash, play, play == 0 ? 0 : 1e-12 * pair.centre_distance);
    // Near the base circles shifts hardly move the centres, and are not as well known.
    EXPECT_NEAR(profile_shift_sum(pair.gears, pair.centre_distance, play), shifts, 1e-11);
  }
  EXPECT_GE(tested, 450);
}

TEST(SpurPair, TeethCutByTheirMatesOverlapWithoutRoom) {
  const std::array<SpurGear, 2> gears{SpurGear{.teeth = 20}, SpurGear{.teeth = 30}};
  EXPECT_LT(gear::geometry({gears, 24.9}).backlash, 0);
  const double base = base_radius(gears[0]) + base_radius(gears[1]);
  EXPECT_TRUE(std::isnan(gear::geometry({gears, 0.99 * base}).working_pressure_angle));
  EXPECT_TRUE(std::isnan(profile_shift_sum(gears, 0.99 * base)));
  std::array<SpurGear, 2> negative = gears;
  for (SpurGear& g : negative) g.profile_shift = -2;  // no involute is negative
  EXPECT_TRUE(std::isnan(centre_distance_without_backlash(negative)));
  EXPECT_TRUE(std::isnan(centre_distance_with_backlash(gears, -0.1)));
}

TEST(SpurPair, PathsEndAtPointedTipsAndFormCircles) {
  // The wheel's tip is prolonged until it meets the pinion's fillet.
  SpurPair pair{{SpurGear{.teeth = 20}, SpurGear{.teeth = 60}}, 40};
  EXPECT_EQ(geometry(pair).gears[0].interference, 0);
  pair.gears[1].tip_reduction = -0.2;
  const PairGeometry deep = geometry(pair);
  EXPECT_GT(deep.gears[0].interference, 0);
  EXPECT_EQ(deep.gears[1].interference, 0);
  EXPECT_NEAR(deep.gears[0].contact_start, form_radius(pair.gears[0]), 1e-12);
  // The pinion's tip goes through the root circle of the wheel.
  const std::array<SpurGear, 2> close{SpurGear{.teeth = 30, .tip_reduction = -0.3},
                                      SpurGear{.teeth = 60}};
  EXPECT_LT(gear::geometry({close, 45}).gears[0].tip_clearance, 0);
  EXPECT_GT(gear::geometry({close, 45}).gears[1].interference, 0);
  EXPECT_EQ(gear::geometry({close, 45}).gears[0].interference, 0);
  // No interference that rounding alone would make: both tips reach to the form circle exactly.
  for (int teeth = 18; teeth < 80; ++teeth) {
    const SpurGear g{.teeth = static_cast<double>(teeth)};
    EXPECT_EQ(gear::geometry({{g, g}, static_cast<double>(teeth)}).gears[0].interference, 0);
  }
  // A pointed tooth ends where it is pointed.
  const SpurGear sharp{.teeth = 8, .profile_shift = 0.9};
  const SpurPair pointed{{sharp, SpurGear{.teeth = 30}},
                         gear::centre_distance_without_backlash({sharp, SpurGear{.teeth = 30}})};
  EXPECT_NEAR(geometry(pointed).gears[0].contact_end, pointed_radius(sharp), 1e-12);
  // Gears too far apart do not touch at all.
  const PairGeometry apart = gear::geometry({{SpurGear{.teeth = 20}, SpurGear{.teeth = 30}}, 27.5});
  EXPECT_EQ(apart.contact_ratio, 0);
  EXPECT_EQ(apart.path_length, 0);
  EXPECT_TRUE(std::isfinite(apart.gears[0].sliding_start));
}

TEST(SpurPair, AllocatesNothing) {
  for (const SpurPair& pair : pairs()) {
    const std::size_t before = test::allocations();
    const PairGeometry result = geometry(pair);
    const double shift = balanced_shift(pair, -1, 1);
    const auto fault = tooth_fault(pair.gears[0]);
    EXPECT_EQ(test::allocations(), before);
    EXPECT_EQ(fault, gear::ToothFault::none);
    EXPECT_TRUE(std::isfinite(shift + result.contact_ratio));
  }
}

TEST(SpurPair, BalancedSlidingIsEqualAtBothFeet) {
  for (const auto& [z1, z2, sum] :
       {std::array{18.0, 40.0, 0.0}, {15.0, 45.0, 0.6}, {30.0, 30.0, 0.4}, {40.0, 18.0, 0.0}}) {
    SpurPair pair{{SpurGear{.teeth = z1, .profile_shift = sum}, SpurGear{.teeth = z2}}};
    pair.centre_distance = centre_distance_without_backlash(pair.gears);
    const double shift = balanced_shift(pair, -1, 1.5);
    pair.gears[0].profile_shift = shift;
    pair.gears[1].profile_shift = sum - shift;
    const PairGeometry result = geometry(pair);
    EXPECT_NEAR(result.gears[0].sliding_start, result.gears[1].sliding_start, 1e-9) << z1;
    EXPECT_GT(result.gears[0].sliding_start, -3);
    EXPECT_TRUE(z1 != z2 || std::abs(shift - 0.5 * sum) < 1e-12) << shift;
    EXPECT_EQ(balanced_shift(pair, -1, shift - 0.1), shift - 0.1);
    EXPECT_EQ(balanced_shift(pair, shift + 0.1, 1.5), shift + 0.1);
  }
}

}  // namespace
}  // namespace cognate::gear_pair_test
