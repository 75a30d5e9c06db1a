/// @file Each body's own travel: how far along its guide, or turned by what angle.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/mechanism/mechanism.hpp"
#include "analysis/mechanism/motion_state.hpp"
#include "analysis/mechanism/sliding_pairs.hpp"

namespace cognate {

/// What a body's travel is counted by. A body that slides on a guide (a driving slider, the slider
/// of an RRP or RPP, both bodies of a PRP, the blocks of a floating link), or in a slot (the block
/// of an RPP): by its displacement along that slide, relative to the body with the slide. Every
/// other body, both of an RPR included: by its angle from the x axis.
struct Travel {
  int body = 0;
  bool slides = false;
  SlidingPair pair;  ///< where it slides
};

/// Of each body, the frame (which turns by nothing) first.
std::vector<Travel> travels(const Mechanism<double>& mechanism);

/// The displacement from the guide's `through` (or from the slider's origin in a slot), or the
/// angle in [−π, π].
template <int Order>
double travelled(const Travel& travel, std::span<const BodyMotion<double, Order>> bodies) {
  if (travel.slides) return displacement<Order>(travel.pair, bodies)[0];
  const Vec2d& direction = bodies[static_cast<std::size_t>(travel.body)].direction;
  return std::atan2(direction.y, direction.x);
}

/// Its derivative by the drive coordinate; needs Order ≥ 1.
template <int Order>
double travel_rate(const Travel& travel, std::span<const BodyMotion<double, Order>> bodies) {
  static_assert(Order >= 1);
  if (travel.slides) return displacement<Order>(travel.pair, bodies)[1];
  return bodies[static_cast<std::size_t>(travel.body)].turn[0];
}

}  // namespace cognate
