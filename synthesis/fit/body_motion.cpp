#include "synthesis/fit/body_motion.hpp"

#include <cmath>

#include "analysis/numbers/angle.hpp"

namespace cognate::synthesis {

RestingPoint resting_point(std::span<const Pose> poses) {
  const double share = 1 / static_cast<double>(poses.size());
  Vec2d at{}, turn{};
  for (const Pose& pose : poses) {
    at = at + share * pose.at;
    turn = turn + share * unit_vector(pose.angle);
  }
  // Places are d + e c; over all poses d − d̄ is to be as near to −(e − ē) c as can be.
  Vec2d product{};
  double turned = 0, straight = 0;
  for (const Pose& pose : poses) {
    const Vec2d e = unit_vector(pose.angle) - turn;
    product = product + conj(e) * (pose.at - at);
    turned += squared_norm(e);
    straight += squared_norm(pose.at - at);
  }
  constexpr double kTranslation = 1e-20;  // squared angles below this, in radians, are none
  RestingPoint point;
  if (turned > kTranslation * static_cast<double>(poses.size())) {
    point.in_body = (-1 / turned) * product;
    straight = 0;
    for (const Pose& pose : poses) {
      const Vec2d e = unit_vector(pose.angle) - turn;
      straight += squared_norm(pose.at - at + e * point.in_body);
    }
  }
  point.mean = at + turn * point.in_body;
  point.travel = std::sqrt(share * straight);
  return point;
}

std::vector<Vec2d> places_of(std::span<const Pose> poses, const Vec2d& in_body) {
  std::vector<Vec2d> places;
  places.reserve(poses.size());
  for (const Pose& pose : poses) places.push_back(to_frame(pose, in_body));
  return places;
}

std::vector<Pose> inverse_motion(std::span<const Pose> poses) {
  std::vector<Pose> inverse;
  inverse.reserve(poses.size());
  for (const Pose& pose : poses) inverse.push_back({to_body(pose, {0, 0}), -pose.angle});
  return inverse;
}

}  // namespace cognate::synthesis
