#include "synthesis/exact/motion/pose.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

constexpr double kNoTurn = 1e-14;

}  // namespace

Vec2d to_frame(const Pose& pose, const Vec2d& p) {
  return pose.at + unit_vector(pose.angle) * p;
}

Vec2d to_body(const Pose& pose, const Vec2d& p) {
  return conj(unit_vector(pose.angle)) * (p - pose.at);
}

Vec2d Displacement::way(const Vec2d& x) const {
  return shift + turn_less_one * (x - about);
}

Displacement displacement(const Pose& from, const Pose& to) {
  const double angle = std::remainder(to.angle - from.angle, kTurn);
  const Vec2d half = unit_vector(0.5 * angle);
  return {from.at, to.at - from.at, angle, Vec2d{0, 2 * half.y} * half};
}

std::optional<Vec2d> pole(const Displacement& displacement) {
  const Vec2d& c = displacement.turn_less_one;
  if (!(std::abs(displacement.angle) > kNoTurn)) return std::nullopt;
  return displacement.about - (1 / squared_norm(c)) * (displacement.shift * conj(c));
}

SegmentPoses poses_of_segment(std::span<const Vec2d> first, std::span<const Vec2d> second) {
  SegmentPoses result;
  if (first.size() != second.size() || first.empty()) return result;
  double least = 0, greatest = 0, sum = 0;
  for (std::size_t j = 0; j < first.size(); ++j) {
    const Vec2d along = second[j] - first[j];
    const double length = norm(along);
    if (!(length > 0)) return {};
    least = j == 0 ? length : std::min(least, length);
    greatest = std::max(greatest, length);
    sum += length;
    result.poses.push_back({first[j], std::atan2(along.y, along.x)});
  }
  result.length = sum / static_cast<double>(first.size());
  result.spread = greatest - least;
  return result;
}

}  // namespace cognate::synthesis
