#include "analysis/linkage/motion.hpp"

#include <cmath>

#include "analysis/numbers/angle.hpp"

namespace cognate {

Motion::Motion(const FourBar& linkage)
    : linkage_(linkage), axes_(linkage), closure_(axes_.lengths(), axes_.frame_low()) {}

LinkDirections<double> Motion::directions(double crank_angle_from_frame) const {
  return closure_.at(crank_direction(crank_angle_from_frame), sign(linkage_.assembly));
}

std::optional<Pose> Motion::at(double crank_angle) const {
  const LinkDirections<double> links =
      closure_.at(crank_direction(axes_.half_crank(crank_angle)), sign(linkage_.assembly));
  if (!(links.discriminant >= 0) || !std::isfinite(links.coupler.x)) return std::nullopt;
  return pose(linkage_, axes_.direction(), crank_angle, links);
}

Pose pose(const FourBar& linkage, const Vec2d& frame_direction, double crank_angle,
          const LinkDirections<double>& links) {
  const Vec2d coupler = frame_direction * links.coupler;
  const Vec2d rocker = frame_direction * links.rocker;
  Pose pose;
  pose.b = linkage.pivot_a + linkage.crank * unit_vector(crank_angle);
  pose.c = linkage.pivot_d + linkage.rocker * rocker;
  if (linkage.coupler_point) pose.coupler_point = pose.b + coupler * *linkage.coupler_point;
  pose.rocker_angle = std::atan2(rocker.y, rocker.x);
  pose.transmission_angle = std::atan2(std::abs(cross(coupler, rocker)), dot(coupler, rocker));
  return pose;
}

}  // namespace cognate
