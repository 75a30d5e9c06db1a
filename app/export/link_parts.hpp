/// @file The links of a linkage as flat parts to be cut.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/drawing/link_shapes.hpp"
#include "app/drawing/plan.hpp"

namespace cognate::app {

/// What parts are cut to, in the lengths of the linkage.
struct PartOrder {
  double hole = 0;                  ///< diameter of the holes and pins
  double width = 0;                 ///< of the bars, and of the ends about every hole
  double clearance = 0;             ///< how much wider a slot is than a pin
  std::optional<double> gap;        ///< between parts on the sheet; empty: half the width
  std::optional<double> thickness;  ///< of the sheet, for the lengths of the pins
};

struct PartHole {
  std::string name;
  Vec2d at{};
  bool pin = true;  ///< whether a pin goes through; else the hole marks a named point
};

/// A slot for a pin: the way of the pin's centre.
struct PartSlot {
  std::string name;  ///< of the link that slides in it
  Vec2d from{}, to{};
};

/// A link with its holes, in its own axes. Its outline keeps half the width from `hull`.
struct LinkPart {
  int link = 0;
  std::string name;
  std::vector<PartHole> holes;
  std::vector<PartSlot> slots;
  std::vector<Vec2d> hull;  ///< corners, counter-clockwise: one, two or more
};

/// A pin, and the parts that it goes through: indices of `parts`.
struct PartPin {
  std::string name;
  Attached<double> at{};
  std::vector<int> parts;
};

struct LinkParts {
  std::vector<LinkPart> parts;  ///< the frame first
  std::vector<PartPin> pins;
  std::vector<std::string> notes;
};

/// The parts of the links: a hole at every joint and named point (but none at a point in a slot), a
/// slot for everything that slides on the link, and about them the convex hull with round ends. A
/// slider with nothing but one joint is no part: it is a pin in the slot. One with more has two
/// pins of its own in the slot, which keep its direction. The error says which holes would overlap
/// and what is allowed.
tl::expected<LinkParts, std::string> link_parts(const LinkShapes& shown, const PartOrder& order);

/// The outline at `distance` about the convex polygon `hull`: lines and arcs. None of a mere point.
PlanOutline rounded_outline(const std::string& layer, const std::vector<Vec2d>& hull,
                            double distance);

}  // namespace cognate::app
