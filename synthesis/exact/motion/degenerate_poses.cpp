#include "synthesis/exact/motion/degenerate_poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/motion/three_poses.hpp"

namespace cognate::synthesis {
namespace {

/// The residual up to which poses count as being on one circle or line.
constexpr double kOnCurve = 1e-12;

/// The body's origin at the first pose, the one farthest from it, and the one farthest from both
/// (by the product): their circle is the best determined.
std::array<Pose, 3> spread_poses(std::span<const Pose> poses) {
  const auto farthest = [&](auto measure) {
    std::size_t best = 0;
    for (std::size_t j = 1; j < poses.size(); ++j) {
      if (measure(poses[j].at) > measure(poses[best].at)) best = j;
    }
    return poses[best];
  };
  const Vec2d first = poses[0].at;
  const Pose second = farthest([&](const Vec2d& at) { return norm(at - first); });
  const Pose third =
      farthest([&](const Vec2d& at) { return norm(at - first) * norm(at - second.at); });
  return {poses[0], second, third};
}

struct Gap {
  double middle = 0;
  double width = 0;
};

/// The widest gap between angles, modulo `period`.
Gap widest_gap(std::vector<double> angles, double period) {
  for (double& angle : angles) angle -= period * std::floor(angle / period);
  std::ranges::sort(angles);
  Gap widest;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const bool last = i + 1 == angles.size();
    const double width = (last ? angles[0] + period : angles[i + 1]) - angles[i];
    if (width > widest.width) widest = {angles[i] + 0.5 * width, width};
  }
  return widest;
}

/// From a link that carries the body without turning it to its equal: 1.5 times as long, so that
/// frame and crank differ. Where the link turns less than half a turn all its positions are on
/// one side of the frame, and as far from it as they can be; else no position is along the frame.
Vec2d to_second_link(std::span<const Pose> poses, const Vec2d& link) {
  constexpr double kLonger = 1.5;
  std::vector<double> angles;
  for (const Pose& pose : poses) {
    const Vec2d at = link + (pose.at - poses[0].at);
    angles.push_back(std::atan2(at.y, at.x));
  }
  const Gap of_turn = widest_gap(angles, kTurn);
  const double direction = of_turn.width > kPi ? of_turn.middle + kRightAngle
                                               : widest_gap(std::move(angles), kPi).middle;
  return kLonger * norm(link) * unit_vector(direction);
}

DyadSolutions translation(std::span<const Pose> poses) {
  DyadSolutions result{GuidanceStatus::translation, {}, 0};
  const std::array<Pose, 3> three = spread_poses(poses);
  const DyadSolutions centre = dyads_with_moving_pivot(three, {});
  if (centre.count == 0) return result;
  const GuidingDyad& found = centre.storage[0];
  if (found.kind == DyadKind::pr) {
    const GuidingDyad slider = pr_dyad(poses, {}, found.direction);
    if (slider.residual <= kOnCurve) result.add(slider);
    return result;
  }
  const GuidingDyad link = rr_dyad(poses, {}, found.fixed);
  if (!(link.residual <= kOnCurve)) return result;
  const Vec2d aside = to_second_link(poses, link.moving - link.fixed);
  result.add(link);
  result.add(rr_dyad(poses, to_body(poses[0], link.moving + aside), link.fixed + aside));
  return result;
}

DyadSolutions rotation(std::span<const Pose> poses) {
  DyadSolutions result{GuidanceStatus::rotation, {}, 0};
  for (std::size_t j = 1; j < poses.size() && result.count == 0; ++j) {
    const auto centre = pole(displacement(poses[0], poses[j]));
    if (centre) result.add(rr_dyad(poses, to_body(poses[0], *centre), *centre));
  }
  return result;
}

}  // namespace

DyadSolutions degenerate_dyads(std::span<const Pose> poses, GuidanceStatus status) {
  if (status == GuidanceStatus::translation) return translation(poses);
  if (status == GuidanceStatus::rotation) return rotation(poses);
  return {status, {}, 0};
}

}  // namespace cognate::synthesis
