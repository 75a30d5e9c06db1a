/// @file The links of a linkage as flat parts to be cut.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/drawing/link_shapes.hpp"
#include "app/drawing/plan.hpp"
#include "app/export/parts/bearings.hpp"
#include "app/export/parts/screws.hpp"
#include "problems/layers/layers.hpp"

namespace cognate::app {

/// How parts are named on the sheet: not at all, by texts, or by the strokes of an engraver.
enum class PartLabels { none, text, stroke };

/// What parts are cut to, in the lengths of the linkage.
struct PartOrder {
  double hole = 0;                  ///< diameter of the pins, and of holes without a bearing
  double width = 0;                 ///< of the bars, and of the ends about every hole
  double clearance = 0;             ///< how much wider a slot is than a pin
  std::optional<double> gap;        ///< between parts on the sheet; empty: half the width
  std::optional<double> thickness;  ///< of the sheet, for the lengths of the pins
  double kerf = 0;                  ///< width of the cut; what is drawn is the beam's way
  PartLabels labels = PartLabels::text;
  std::optional<Bearing> bearing;  ///< on which links turn on their pins
  std::optional<Screw> screw;      ///< that pins are, with nuts and washers
  double washer = 0;               ///< thickness of washers between layers
  double washer_outside = 0;       ///< their outside diameter; 0 where it is not chosen
  std::optional<Vec2d> sheet;      ///< width and height of the sheets that parts are cut from
  bool bill = false;               ///< whether the bill of material is a file of its own
  bool spacers = false;            ///< whether spacers are parts as well
  std::optional<double> boss;      ///< diameter of bosses on solid plates in place of spacers
  std::optional<Vec2d> block;      ///< length and width of the blocks of sliders
  std::vector<problems::LinkWidth> widths{};  ///< of links that have their own
  double apart = 0;  ///< that parts and pins of one layer keep from each other

  double width_of(const std::string& link) const;
  double narrowest() const;  ///< of all widths
};

struct PartHole {
  std::string name;
  Vec2d at{};
  bool pin = true;      ///< whether a pin goes through; else the hole marks a named point
  double diameter = 0;  ///< of the finished hole
};

/// A slot for a pin or a block, with round ends about `from` and `to`.
struct PartSlot {
  std::string name;  ///< of the link that slides in it
  Vec2d from{}, to{};
  double width = 0;  ///< of the finished slot
};

/// A link with its holes, in its own axes. Its outline keeps `rim` from `hull`. A driving cylinder
/// is one part with its rod, without holes: what it takes of its layer is the hull of `hull` and of
/// points on the rod.
struct LinkPart {
  int link = 0;  ///< −1 of a spacer
  std::string name;
  std::vector<PartHole> holes;
  std::vector<PartSlot> slots;
  std::vector<Vec2d> hull;  ///< corners, counter-clockwise: one, two or more
  double rim = 0;           ///< half the width
  std::vector<Attached<double>> on_rod{};
  std::optional<CylinderLengths> cylinder{};  ///< where it is one, which is bought, not cut
};

/// A pin, and the parts that it goes through: indices of `parts`.
struct PartPin {
  std::string name;
  Attached<double> at{};
  std::vector<int> parts;
  int bearings = 0;  ///< on it
};

/// A block about the pin of a slider: it lies in a slot, and in the layer of the part with that.
struct SlidingBlock {
  LinkPart part;
  std::size_t bearer = 0;  ///< index of the part with the slot
};

struct LinkParts {
  std::vector<LinkPart> parts;  ///< the frame first
  std::vector<SlidingBlock> blocks;
  std::vector<PartPin> pins;
  std::vector<std::string> notes;
};

/// Whether a wall beside a hole is so thin that it may break: less than a tenth of the hole.
bool is_thin(double wall, const PartOrder& order);

/// The parts of the links: a hole at every joint and named point (but none at a point in a slot), a
/// slot for everything that slides on the link, and about them the convex hull with round ends. A
/// slider with nothing but one joint is a pin in the slot, with the block of the order about it
/// where there is one. One with more has two pins of its own in the slot, which keep its
/// direction. With a bearing a pin is fast in the first
/// of its links, the frame if it joins that, and the holes of the others take the bearing. A
/// driving cylinder is one part with its rod, with no outline. The error says which size is not
/// possible, or which holes would overlap, and what is allowed.
tl::expected<LinkParts, std::string> link_parts(const LinkShapes& shown, const PartOrder& order);

}  // namespace cognate::app
