#include "synthesis/exact/motion/dyad.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"

namespace cognate::synthesis {
namespace {

/// |moving − fixed| at `j` less that at the first pose.
double distance_change(const GuidingDyad& dyad, const Displacement& to) {
  const Vec2d link = dyad.moving - dyad.fixed;
  const Vec2d way = to.way(dyad.moving);
  const double lengths = norm(link) + norm(link + way);
  return lengths > 0 ? dot(way, (1 / lengths) * (2.0 * link + way)) : 0;
}

/// How the frame's point `x` moves as the body sees it, in the axes of the body at the first pose
/// taken as those of the frame.
Vec2d seen_way(const Displacement& to, const Vec2d& x) {
  return conj(to.turn_less_one) * (x - to.about - to.shift) - to.shift;
}

double change(const GuidingDyad& dyad, const Pose& first, const Pose& pose) {
  const Displacement to = displacement(first, pose);
  switch (dyad.kind) {
    case DyadKind::rr:
      return distance_change(dyad, to);
    case DyadKind::pr:
      return cross(dyad.direction, to.way(dyad.moving));
    case DyadKind::rp:
      break;
  }
  const Vec2d line = unit_vector(first.angle) * dyad.direction;
  return cross(line, seen_way(to, dyad.fixed));
}

GuidingDyad measured(GuidingDyad dyad, std::span<const Pose> poses) {
  dyad.residual = guidance_residual(dyad, poses);
  return dyad;
}

}  // namespace

double extent(std::span<const Pose> poses) {
  double greatest = 0;
  for (const Pose& pose : poses) greatest = std::max(greatest, norm(pose.at - poses[0].at));
  return greatest;
}

double guidance_residual(const GuidingDyad& dyad, std::span<const Pose> poses) {
  double greatest = 0;
  for (const Pose& pose : poses) {
    greatest = std::max(greatest, std::abs(change(dyad, poses[0], pose)));
  }
  const double size = extent(poses);
  if (size > 0) return greatest / size;
  return dyad.length > 0 ? greatest / dyad.length : greatest;
}

GuidingDyad rr_dyad(std::span<const Pose> poses, const Vec2d& in_body, const Vec2d& fixed) {
  GuidingDyad dyad{DyadKind::rr, in_body, to_frame(poses[0], in_body), fixed};
  double changes = 0;
  for (const Pose& pose : poses) changes += distance_change(dyad, displacement(poses[0], pose));
  dyad.length = norm(dyad.moving - fixed) + changes / static_cast<double>(poses.size());
  return measured(dyad, poses);
}

GuidingDyad pr_dyad(std::span<const Pose> poses, const Vec2d& in_body, const Vec2d& direction) {
  const Vec2d moving = to_frame(poses[0], in_body);
  return measured({DyadKind::pr, in_body, moving, moving, direction}, poses);
}

GuidingDyad rp_dyad(std::span<const Pose> poses, const Vec2d& fixed, const Vec2d& direction) {
  return measured({DyadKind::rp, to_body(poses[0], fixed), fixed, fixed, direction}, poses);
}

std::string_view sentence(GuidanceStatus status) {
  switch (status) {
    case GuidanceStatus::found:
      return "all dyads were found";
    case GuidanceStatus::none:
      return "no real dyad guides the body through these poses";
    case GuidanceStatus::out_of_reach:
      return "the link is shorter than half the way of its moving pivot";
    case GuidanceStatus::coincident_poses:
      return "two of the poses are the same, so that a condition is missing";
    case GuidanceStatus::pivot_at_rest:
      return "the pivot does not move between two of the poses (it is their pole), so that its "
             "partner is not determined";
    case GuidanceStatus::same_line:
      return "every point of the line given will do";
    case GuidanceStatus::translation:
      return "no pose is turned against another (the poles are at infinity): a moving pivot and "
             "its "
             "fixed pivot may be moved together anywhere";
    case GuidanceStatus::rotation:
      return "all poses are turns about one point: a pin there guides the body";
    case GuidanceStatus::family:
      return "infinitely many dyads guide the body through these poses";
    case GuidanceStatus::not_finite:
      break;
  }
  return "a number of the poses or of what is requested is not finite";
}

}  // namespace cognate::synthesis
