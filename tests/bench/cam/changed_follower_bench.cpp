/// What it costs to find a follower whose dimensions are off, on the cam as it was cut, against
/// the follower as designed at the same cam angles, both in one run: one line for each type.
#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "analysis/cam/changed_follower.hpp"
#include "analysis/cam/contact.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/bench/kernel/measure.hpp"

namespace cognate::bench {
namespace {

constexpr int kPositions = 360;
constexpr int kRounds = 50;

cam::Cam cam_of(cam::FollowerType type) {
  const bool swings = is_oscillating(type);
  const double rise = swings ? 0.4 : 20;
  cam::Cam made;
  made.programme = *cam::programme_of(
      {{.law = cam::MotionLaw::cycloidal, .over = kTurn / 2, .rise = rise},
       {.law = cam::MotionLaw::polynomial_345, .over = kTurn / 2, .rise = -rise}});
  auto& follower = made.system.follower;
  follower.type = type;
  auto& d = follower.dimensions;
  d.base_radius = 50;
  if (swings) d.centre_distance = 120;
  if (has_arm(type)) d.arm = 100;
  if (!is_flat(type)) d.roller_radius = 8;
  if (type == cam::FollowerType::translating_roller) d.offset = 5;
  made.system.start = starting_place(follower);
  return made;
}

void compare(const char* name, cam::FollowerType type) {
  const cam::Cam cam = cam_of(type);
  std::vector<cam::ChangedFollower> followers;
  std::vector<double> angles;
  for (int k = 0; k < kPositions; ++k) {
    angles.push_back(kTurn * k / kPositions);
    followers.emplace_back(cam, angles.back());
  }
  const cam::CamDimensions<double> changes{.base_radius = 0.02,
                                           .offset = 0.05,
                                           .roller_radius = -0.01,
                                           .centre_distance = 0.03,
                                           .arm = -0.02,
                                           .face_offset = 0.04};
  volatile double sink = 0;
  std::vector<Case> cases{
      {"changed", kPositions,
       [&] {
         double sum = 0;
         for (const auto& follower : followers) sum += follower.misplacement(changes).value_or(0);
         sink = sum;
       }},
      {"as designed", kPositions, [&] {
         double sum = 0;
         for (const double angle : angles) {
           const auto motion = cam.programme.at(angle);
           sum += is_flat(type)
                      ? face_state(cam.system.follower, cam.system.start, motion).reach
                      : roller_state(cam.system.follower, cam.system.start, motion).across;
         }
         sink = sum;
       }}};
  measure(cases, kRounds);
  fmt::print("{:20} {:6.0f} ns, as designed {:5.0f} ns, ratio {:.1f}\n", name, cases[0].nanoseconds,
             cases[1].nanoseconds, cases[0].nanoseconds / cases[1].nanoseconds);
}

}  // namespace
}  // namespace cognate::bench

int main() {
  using cognate::cam::FollowerType;
  cognate::bench::compare("translating-roller", FollowerType::translating_roller);
  cognate::bench::compare("oscillating-roller", FollowerType::oscillating_roller);
  cognate::bench::compare("oscillating-flat", FollowerType::oscillating_flat);
}
