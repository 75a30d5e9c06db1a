/// @file Kinematic inversion: the frame as a body that moves before the guided body.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// The poses of the fixed frame, its origin put at `origin`, in the axes of the body.
template <std::size_t Count>
std::array<Pose, Count> seen_from_body(std::span<const Pose, Count> poses, const Vec2d& origin) {
  std::array<Pose, Count> seen{};
  for (std::size_t j = 0; j < Count; ++j) seen[j] = {to_body(poses[j], origin), -poses[j].angle};
  return seen;
}

/// Dyads found for the frame as the moving body, its origin at `origin`, as dyads of the body:
/// moving and fixed pivot change places, and pr and rp.
DyadSolutions seen_from_frame(const DyadSolutions& inverted, std::span<const Pose> poses,
                              const Vec2d& origin);

}  // namespace cognate::synthesis
