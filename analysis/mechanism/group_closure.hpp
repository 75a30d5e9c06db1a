/// @file Closing a group of bodies by Newton's method, and its motion of any order.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include "analysis/mechanism/group.hpp"
#include "analysis/mechanism/motion_state.hpp"
#include "analysis/numbers/dual.hpp"

namespace cognate {

/// Puts the bodies of a group where it is drawn.
template <class T, int Order>
void place_drawn(const Group& group, std::span<BodyMotion<T, Order>> bodies) {
  for (std::size_t i = 0; i < group.drawn.size(); ++i) {
    const auto& [origin, direction] = group.drawn[i];
    bodies[i].origin[0] = {T(origin.x), T(origin.y)};
    bodies[i].direction = {T(direction.x), T(direction.y)};
  }
}

/// Closes the group whose first body is `first` from where its bodies stand in `bodies` nearby, and
/// fills their motion. `side` 0: its bodies stay where they are. `sine` of the closure is the
/// group's (group_equations.hpp). Where Newton's method does not converge, bodies and closure are
/// not numbers.
template <int Order>
DyadClosure<double> close_group_of(const Group& group, std::size_t first, double side,
                                   std::span<BodyMotion<double, Order>> bodies);

/// The same with derivatives by the drive's coordinate.
DyadClosure<Dual> close_group_of(const Group& group, std::size_t first, double side,
                                 std::span<BodyMotion<Dual, 0>> bodies);

/// The same over any type of number.
template <int Order, class T>
DyadClosure<T> close_group(const Group& group, std::size_t first, const T& side,
                           std::span<BodyMotion<T, Order>> bodies) {
  if constexpr (std::is_same_v<T, double>) {
    return close_group_of<Order>(group, first, side, bodies);
  } else if constexpr (std::is_same_v<T, Dual> && Order == 0) {
    return close_group_of(group, first, side.value, bodies);
  } else {
    const T none(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < group.drawn.size(); ++i) {
      bodies[first + i].direction = bodies[first + i].origin[0] = {none, none};
    }
    return {none, none, none};
  }
}

}  // namespace cognate
