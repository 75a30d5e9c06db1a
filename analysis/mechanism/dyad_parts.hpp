/// @file What the closures of all dyads share: their result, and points and guides of the bodies
/// that they depend on.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "analysis/mechanism/motion_terms.hpp"

namespace cognate {

/// The two bodies of a dyad, and how well it is closed.
template <class T, int Order>
struct DyadMotion {
  BodyMotion<T, Order> first{};
  BodyMotion<T, Order> second{};
  DyadClosure<T> closure{};
};

/// The bodies so far.
template <class T, int Order>
using BodiesBefore = std::span<const BodyMotion<T, Order>>;

/// The guide's direction in global axes.
template <class T, int Order>
Vec2<T> direction_of(const Guide<T>& guide, BodiesBefore<T, Order> bodies) {
  return bodies[static_cast<std::size_t>(guide.body)].direction * guide.direction;
}

/// The motion of an attached point.
template <class T, int Order>
std::array<Vec2<T>, Order + 1> motion_of(const Attached<T>& point, BodiesBefore<T, Order> bodies) {
  return point_motion(bodies[static_cast<std::size_t>(point.body)], point.at);
}

}  // namespace cognate
