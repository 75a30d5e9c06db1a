#include "synthesis/exact/motion/seen_from_body.hpp"

namespace cognate::synthesis {
namespace {

GuidingDyad dyad_of(const GuidingDyad& inverted, std::span<const Pose> poses, const Vec2d& origin) {
  const Vec2d fixed = origin + inverted.in_body;
  switch (inverted.kind) {
    case DyadKind::rr:
      return rr_dyad(poses, inverted.fixed, fixed);
    case DyadKind::pr:
      return rp_dyad(poses, fixed, inverted.direction);
    case DyadKind::rp:
      break;
  }
  return pr_dyad(poses, inverted.fixed, inverted.direction);
}

}  // namespace

DyadSolutions seen_from_frame(const DyadSolutions& inverted, std::span<const Pose> poses,
                              const Vec2d& origin) {
  DyadSolutions result{inverted.status, {}, 0};
  for (const GuidingDyad& dyad : inverted.dyads()) {
    result.add(dyad_of(dyad, poses, origin));
    result.storage[static_cast<std::size_t>(result.count - 1)].condition = dyad.condition;
  }
  return result;
}

}  // namespace cognate::synthesis
