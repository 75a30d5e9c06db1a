/// @file An Assur group of class III or higher: four bodies or more that close together on what is
/// there before, and not in pairs, such as a link with three pins on three others.
#pragma once

#include <vector>

#include "analysis/mechanism/attached.hpp"

namespace cognate {

/// A pin or a slide of two bodies, one of the group or both. A pin is at the same place on either.
/// A slide moves the point `second` along the line through `first` in the direction `along_first`,
/// to which the direction `along_second` stays parallel; both are unit vectors in the axes of their
/// bodies.
struct GroupJoint {
  Attached<double> first{};
  Attached<double> second{};
  bool slides = false;
  Vec2d along_first{1, 0};
  Vec2d along_second{1, 0};
};

/// An Assur group of an even number of bodies and 3/2 as many joints. It has no formula, and up to
/// six assemblies or more: which of them is meant, `drawn` says, the places of its bodies while the
/// drive is at `drive`. Every other position is that which a motion from there leads to.
struct Group {
  std::vector<Placement> drawn;
  std::vector<GroupJoint> joints;
  double drive = 0;
};

/// The most bodies of a group.
inline constexpr int kMostGroupBodies = 16;

/// Says that two more bodies belong to the group before.
struct GroupRest {};

}  // namespace cognate
