#include "problems/cam/second_contact.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/cam/extremes.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/cam/variables.hpp"

namespace cognate::problems {
namespace {

/// Cam angles of the first half turn between which both a position and its opposite one stay within
/// a piece each.
std::vector<double> borders(const cam::MotionProgramme& programme) {
  std::vector<double> angles = {0, kPi};
  for (const auto& piece : programme.pieces()) {
    angles.push_back(piece.begin < kPi ? piece.begin : piece.begin - kPi);
  }
  std::ranges::sort(angles);
  return angles;
}

/// highest − s, piece by piece.
cam::MotionProgramme complement(const cam::MotionProgramme& programme) {
  auto pieces = programme.pieces();
  for (auto& piece : pieces) {
    piece.offset = programme.highest() - piece.offset;
    piece.scale = -piece.scale;
  }
  return cam::MotionProgramme(std::move(pieces));
}

cam::CamFollower<double> conjugate_follower(const cam::Cam& first, const SecondContact& contact) {
  cam::CamFollower<double> second = first.system.follower;
  auto& d = second.dimensions;
  const double reach = first.system.start + first.programme.highest();
  const double equal = reach + first.system.start;  // both cams then have one base radius
  double start = contact.breadth.value_or(equal) - reach;
  if (is_oscillating(second.type)) {
    second.side =
        second.side == cam::ArmSide::trailing ? cam::ArmSide::leading : cam::ArmSide::trailing;
    start = contact.arms_angle.value_or(equal) - reach;
  } else {
    d.offset = -d.offset;
  }
  d.base_radius = start > 0 ? base_radius_at(second.type, d, start) : -1;
  return second;
}

}  // namespace

BreadthFault breadth_fault(const cam::MotionProgramme& programme) {
  const double wanted = programme.at(0).displacement + programme.at(kPi).displacement;
  const auto deviation = [&](double angle) {
    return programme.at(angle).displacement + programme.at(angle + kPi).displacement - wanted;
  };
  BreadthFault worst;
  const auto all = borders(programme);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (!(all[i + 1] - all[i] > 1e-12)) continue;
    const auto here = cam::extremes(deviation, all[i], all[i + 1], programme.highest());
    for (const cam::Extreme& extreme : {here.least, here.greatest}) {
      if (std::abs(extreme.value) > std::abs(worst.deviation)) {
        worst = {extreme.value, extreme.at};
      }
    }
  }
  return worst;
}

double constant_breadth(const cam::Cam& cam) {
  return 2 * cam.system.start + cam.programme.at(0).displacement +
         cam.programme.at(kPi).displacement;
}

std::optional<cam::Cam> conjugate_cam(const cam::Cam& first, const SecondContact& contact) {
  const auto follower = conjugate_follower(first, contact);
  if (!(follower.dimensions.base_radius > follower.dimensions.roller_radius)) return std::nullopt;
  // Its own displacement is highest − s, and it gives what the first cam would have to hold back.
  cam::Operation operation = first.system.operation;
  operation.preload = -operation.preload - operation.spring_rate * first.programme.highest();
  operation.load = -operation.load;
  return cam::Cam{{follower, starting_place(follower), operation}, complement(first.programme)};
}

}  // namespace cognate::problems
