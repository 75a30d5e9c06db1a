/// @file A planar mechanism as data: a driving member and Assur groups, of class II (dyads) or
/// higher.
///
/// Bodies are numbered: 0 is the frame, then the bodies of the drive, then two for each dyad in the
/// order of the list. A dyad joins points and guides of bodies before it, so a mechanism of any
/// number of dyads has the mobility one of its drive and is evaluated from the front to the back.
/// A group of 2n bodies that close together takes the places of n dyads.
///
/// Each body has axes of its own, an origin and a unit vector, in which its points are given:
///
///     frame             the global axes
///     crank             origin at its pivot, first axis towards its pin
///     driving slider    origin where the displacement says, first axis along its guide
///     floating link     origin at its first pin, first axis from there to its second pin
///       its two blocks  origin at the pin, first axis along the guide
///     rod of a cylinder origin at its pin, first axis away from the cylinder
///     cylinder          origin at its pivot, first axis towards the rod's pin
///       its link        origin at its pivot, first axis towards the rod's pin
///     RRR  first        origin at the first point, first axis to the inner joint
///          second       origin at the second point, first axis to the inner joint
///     RRP  first        origin at the point, first axis to the inner joint
///          second       (the slider) origin at the inner joint, first axis along the guide
///     RPR  first        (the block) origin at the block's point, first axis along the guide bar
///          second       (the guide bar) origin at its pivot, first axis along the bar
///     PRP  both         origin at the inner joint, first axis along their guides
///     RPP  first        (the block) origin at the point, first axis along the slot
///          second       origin where slot and guide cross, first axis along the guide
///     group             as the group has them
///
/// The number type may be double, a dual number (exact derivatives by the dimensions), a SIMD pack
/// (many designs at once) or one of extended precision.
#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include "analysis/mechanism/assembly.hpp"
#include "analysis/mechanism/attached.hpp"
#include "analysis/mechanism/group.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A directed straight guide fixed on a body: the line parallel to `direction` (a unit vector) at
/// the signed distance `offset` from the point `through`, positive to the left of the direction.
template <class T>
struct Guide {
  int body = 0;
  Vec2<T> through{};
  Vec2<T> direction{T(1), T(0)};
  T offset{};
};

/// Driven by its angle about a pivot of the frame. Its pin is (length, 0) in its own axes.
template <class T>
struct Crank {
  Vec2<T> pivot{};
  T length{};
};

/// Driven along a guide of the frame by its displacement from the guide's `through`.
template <class T>
struct DrivingSlider {
  Guide<T> guide{};
};

/// A link whose two pins, `length` apart, run in blocks on two guides of the frame, driven by the
/// link's angle: the elliptic trammel.
template <class T>
struct FloatingLink {
  Guide<T> first{};
  Guide<T> second{};
  T length{};
};

/// Driven by the length of a cylinder, from its pivot to the pin of its rod. The body of the drive
/// is the rod; the first dyad must be a `Cylinder`, which places it.
template <class T>
struct DrivingRod {};

/// What drives: one of these.
template <class T>
using Drive = std::variant<Crank<T>, DrivingSlider<T>, FloatingLink<T>, DrivingRod<T>>;

/// Whether the drive's coordinate is a length, not an angle.
template <class T>
bool driven_by_length(const Drive<T>& drive) {
  return std::holds_alternative<DrivingSlider<T>>(drive) ||
         std::holds_alternative<DrivingRod<T>>(drive);
}

/// Two links and three turning joints. `open`: the inner joint lies to the left of the directed
/// line from the first to the second point.
template <class T>
struct Rrr {
  Attached<T> first{}, second{};
  T first_length{}, second_length{};
  Assembly assembly = Assembly::open;
};

/// A link from `point` to the pin of a slider on a guide. `open`: the pin is ahead of the point in
/// the direction of the guide.
template <class T>
struct Rrp {
  Attached<T> point{};
  T length{};
  Guide<T> guide{};
  Assembly assembly = Assembly::open;
};

/// A block turning about `block` and sliding on a bar that turns about `pivot`. With u the bar's
/// direction: block − pivot = (s + i·offset)·u. `open`: s > 0.
template <class T>
struct Rpr {
  Attached<T> block{}, pivot{};
  T offset{};
  Assembly assembly = Assembly::open;
};

/// Two sliders with a common pin where their guides cross.
template <class T>
struct Prp {
  Guide<T> first{}, second{};
};

/// A block turning about `point` in a slot of a slider. `slot` is the unit vector along the slot in
/// the slider's axes; the slot runs through the slider's origin.
template <class T>
struct Rpp {
  Attached<T> point{};
  Vec2<T> slot{T(0), T(1)};
  Guide<T> guide{};
};

/// A cylinder that turns about `base` and a link of `length` that turns about `pivot`, points of
/// the frame, joined by the pin of the driving rod: with the drive's coordinate as the length from
/// base to pin, a triangle. `open`: the pin lies to the left of the directed line from the base to
/// the pivot.
template <class T>
struct Cylinder {
  Attached<T> base{}, pivot{};
  T length{};
  Assembly assembly = Assembly::open;
};

/// Two bodies that close on what is there before: one of these. A group stands first of its places,
/// a `GroupRest` in each of the others.
template <class T>
using Dyad = std::variant<Rrr<T>, Rrp<T>, Rpr<T>, Prp<T>, Rpp<T>, Cylinder<T>, Group, GroupRest>;

/// A drive and dyads, in the order in which they close.
template <class T>
struct Mechanism {
  Drive<T> drive = Crank<T>{};
  std::vector<Dyad<T>> dyads;
};

/// Whether it is a place of a group: no dyad.
template <class T>
bool is_of_group(const Dyad<T>& dyad) {
  return std::holds_alternative<Group>(dyad) || std::holds_alternative<GroupRest>(dyad);
}

/// Whether it has groups other than dyads.
template <class T>
bool has_groups(const Mechanism<T>& mechanism) {
  return std::ranges::any_of(mechanism.dyads, is_of_group<T>);
}

/// How many bodies the drive has: 1, and 3 for a floating link with its blocks.
template <class T>
int drive_bodies(const Mechanism<T>& mechanism) {
  return std::holds_alternative<FloatingLink<T>>(mechanism.drive) ? 3 : 1;
}

/// Number of the first body of dyad `index`; its second is the next.
template <class T>
int first_body(const Mechanism<T>& mechanism, int index) {
  return 1 + drive_bodies(mechanism) + 2 * index;
}

/// How many bodies there are, the frame included.
template <class T>
int body_count(const Mechanism<T>& mechanism) {
  return first_body(mechanism, static_cast<int>(mechanism.dyads.size()));
}

}  // namespace cognate
