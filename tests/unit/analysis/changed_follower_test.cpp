/// Followers whose dimensions are off: by the distance of their roller from the profile, and by
/// differences.
#include "analysis/cam/changed_follower.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/cam/profile.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::cam::changed_follower_test {
namespace {

using Dimensions = CamDimensions<double>;

std::vector<MotionSegment> motion(double rise) {
  return {{.law = MotionLaw::cycloidal, .over = 2.1, .rise = rise},
          {.law = MotionLaw::dwell, .over = 1.0},
          {.law = MotionLaw::cycloidal, .over = 2.1, .rise = -rise},
          {.law = MotionLaw::dwell, .over = kTurn - 5.2}};
}

Cam cam_of(FollowerType type, ArmSide side) {
  const bool swings = is_oscillating(type);
  Cam cam;
  cam.programme = *programme_of(motion(swings ? 0.4 : 20));
  CamFollower<double>& follower = cam.system.follower;
  follower.type = type;
  follower.side = side;
  Dimensions& d = follower.dimensions;
  d.base_radius = 50;
  if (type == FollowerType::translating_roller || type == FollowerType::translating_knife) {
    d.offset = 5;
  }
  if (!is_flat(type) && !is_knife(type)) d.roller_radius = 8;
  if (swings) d.centre_distance = 120;
  if (has_arm(type)) d.arm = 100;
  if (type == FollowerType::oscillating_flat) d.face_offset = 4;
  cam.system.start = starting_place(follower);
  return cam;
}

constexpr std::array kTypes = {FollowerType::translating_roller, FollowerType::translating_flat,
                               FollowerType::translating_knife,  FollowerType::oscillating_roller,
                               FollowerType::oscillating_flat,   FollowerType::oscillating_knife};
constexpr std::array<double Dimensions::*, 6> kMembers = {
    &Dimensions::base_radius,     &Dimensions::offset, &Dimensions::roller_radius,
    &Dimensions::centre_distance, &Dimensions::arm,    &Dimensions::face_offset};

TEST(ChangedFollower, RatesAreThoseOfDifferences) {
  constexpr double kStep = 1e-4;
  for (const FollowerType type : kTypes) {
    for (const ArmSide side : {ArmSide::trailing, ArmSide::leading}) {
      const Cam cam = cam_of(type, side);
      for (int k = 0; k < 36; ++k) {
        const double angle = kTurn * k / 36;
        const auto rates = misplacement_rates(cam, angle);
        const ChangedFollower follower(cam, angle);
        for (std::size_t i = 0; i < kMembers.size(); ++i) {
          Dimensions more{}, less{};
          more.*kMembers[i] = kStep;
          less.*kMembers[i] = -kStep;
          const auto high = follower.misplacement(more), low = follower.misplacement(less);
          ASSERT_TRUE(high && low);
          EXPECT_NEAR(rates[i], (*high - *low) / (2 * kStep), 1e-7)
              << static_cast<int>(type) << ' ' << k << ' ' << i;
        }
      }
    }
  }
}

double distance_from(const std::vector<ProfilePoint>& polygon, const Vec2d& point) {
  double least = kInfinity;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2d a = polygon[i].at, b = polygon[(i + 1) % polygon.size()].at;
    const double along =
        std::clamp(dot(point - a, b - a) / std::max(squared_norm(b - a), 1e-300), 0.0, 1.0);
    least = std::min(least, norm(point - (a + along * (b - a))));
  }
  return least;
}

// Wherever it is put, the roller that is off touches the profile as it was cut.
TEST(ChangedFollower, TheRollerTouchesTheProfile) {
  for (const FollowerType type :
       {FollowerType::translating_roller, FollowerType::oscillating_roller}) {
    const Cam cam = cam_of(type, ArmSide::trailing);
    const Dimensions& d = cam.system.follower.dimensions;
    const auto profile = polygon({cam.system, cam.programme, -d.roller_radius}, 1e-7);
    const bool swings = is_oscillating(type);
    Dimensions changes{};
    changes.roller_radius = 0.3;
    changes.offset = swings ? 0 : -0.4;
    changes.arm = swings ? 0.5 : 0;
    changes.centre_distance = swings ? -0.3 : 0;
    for (int k = 0; k < 24; ++k) {
      const double angle = kTurn * k / 24;
      const auto off = ChangedFollower(cam, angle).misplacement(changes);
      ASSERT_TRUE(off);
      const double place = cam.system.start + cam.programme.at(angle).displacement + *off;
      const Vec2d centre = swings ? Vec2d{-(d.arm + changes.arm) * std::sin(place),
                                          d.centre_distance + changes.centre_distance -
                                              (d.arm + changes.arm) * std::cos(place)}
                                  : Vec2d{d.offset + changes.offset, place};
      const Vec2d seen = in_cam(centre, Vec2d{std::cos(angle), std::sin(angle)});
      EXPECT_NEAR(distance_from(profile, seen), d.roller_radius + changes.roller_radius, 1e-6)
          << static_cast<int>(type) << ' ' << k;
    }
  }
}

/// The least distance of a point from the pitch curve as designed, the cam standing at `angle`.
double distance_from_pitch_curve(const Cam& cam, double angle, const Vec2d& point) {
  const auto at = [&](double along) {
    const auto state = roller_state(cam.system.follower, cam.system.start, cam.programme.at(along));
    const double turn = angle - along;
    return norm(Vec2d{std::cos(turn), std::sin(turn)} * state.centre - point);
  };
  double low = angle - 0.05, high = angle + 0.05;
  for (int step = 0; step < 200; ++step) {
    const double one = low + (high - low) / 3, other = high - (high - low) / 3;
    (at(one) < at(other) ? high : low) = at(one) < at(other) ? other : one;
  }
  return at(0.5 * (low + high));
}

// To the last digits: a roller larger by some stands off the pitch curve by that.
TEST(ChangedFollower, TheRollerStandsOffThePitchCurveByWhatItIsLarger) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1), angles(0, kTurn);
  const Cam cam = cam_of(FollowerType::translating_roller, ArmSide::trailing);
  for (int k = 0; k < 400; ++k) {
    Dimensions changes{};
    changes.roller_radius = 0.2 + 0.1 * any(random);
    changes.offset = 0.3 * any(random);
    const double angle = angles(random);
    const auto off = ChangedFollower(cam, angle).misplacement(changes);
    ASSERT_TRUE(off);
    const double place = cam.system.start + cam.programme.at(angle).displacement + *off;
    const Vec2d centre{cam.system.follower.dimensions.offset + changes.offset, place};
    EXPECT_NEAR(distance_from_pitch_curve(cam, angle, centre), changes.roller_radius, 1e-12) << k;
  }
}

TEST(ChangedFollower, NoChangeIsNoMisplacement) {
  for (const FollowerType type : kTypes) {
    const Cam cam = cam_of(type, ArmSide::trailing);
    for (int k = 0; k < 24; ++k) {
      const auto off = ChangedFollower(cam, kTurn * k / 24).misplacement({});
      ASSERT_TRUE(off);
      EXPECT_NEAR(*off, 0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace cognate::cam::changed_follower_test
