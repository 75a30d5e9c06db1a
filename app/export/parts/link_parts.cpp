#include "app/export/parts/link_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/layers/plates.hpp"
#include "analysis/numbers/convex_hull.hpp"
#include "analysis/numbers/segment.hpp"
#include "app/export/parts/part_blocks.hpp"

namespace cognate::app {
namespace {

/// A slider that carries nothing but its joint.
bool is_mere_pin(const LinkShape& link) {
  return link.shape.block && link.shape.rails.empty() && link.places.size() <= 1;
}

/// Whether a pin of an order at `p` would run into a hole or slot of the part.
bool is_close(const Vec2d& p, const LinkPart& part, const PartOrder& order) {
  const double pin = 0.5 * order.hole + order.clearance;
  return std::ranges::any_of(
             part.holes,
             [&](const PartHole& hole) { return norm(hole.at - p) < pin + 0.5 * hole.diameter; }) ||
         std::ranges::any_of(part.slots, [&](const PartSlot& slot) {
           return distance_to_segment(p, slot.from, slot.to) <
                  pin + 0.5 * (slot.width - order.clearance);
         });
}

bool runs_into(const PartSlot& slot, const PartHole& hole) {
  return distance_to_segment(hole.at, slot.from, slot.to) <= 0.5 * (hole.diameter + slot.width);
}

class PartsMaker {
 public:
  PartsMaker(const LinkShapes& shown, const PartOrder& order)
      : shown_(shown), order_(order), part_of_(shown.links.size(), -1) {}

  LinkParts make() {
    for (std::size_t i = 0; i < shown_.links.size(); ++i) add_part(static_cast<int>(i));
    // The guide pins of a slider, which lengthen the slot, keep off its own slots.
    for (std::size_t i = 0; i < made_.parts.size(); ++i) add_slots(i);
    add_joint_pins();
    if (order_.bearing) seat_bearings();
    for (LinkPart& part : made_.parts) add_guide_pins(part);
    for (LinkPart& part : made_.parts) add_hull(part);
    return std::move(made_);
  }

 private:
  const LinkShape& link(int number) const { return shown_.links[static_cast<std::size_t>(number)]; }
  int part_of(int number) const { return part_of_[static_cast<std::size_t>(number)]; }

  void add_part(int number) {
    const LinkShape& given = link(number);
    if (number > 0 && is_mere_pin(given)) {
      if (!order_.block) {
        made_.notes.push_back(
            fmt::format("{} is no part but the pin that runs in a slot", given.name));
      }
      return;
    }
    if (shown_.cylinder && number == kDrivingRod) return;  // with its cylinder
    part_of_[static_cast<std::size_t>(number)] = static_cast<int>(made_.parts.size());
    if (shown_.cylinder && number == kDrivingCylinder) {
      add_cylinder(given);
      return;
    }
    LinkPart part{number, given.name, {}, {}, {}, 0.5 * order_.width_of(given.name)};
    for (const LinkPlace& place : given.places)
      part.holes.push_back({place.name, place.at, place.joint, order_.hole});
    made_.parts.push_back(std::move(part));
  }

  void add_cylinder(const LinkShape& given) {
    part_of_[kDrivingRod] = part_of_[kDrivingCylinder];
    LinkPart part{.link = kDrivingCylinder,
                  .name = given.name,
                  .rim = 0.5 * order_.width_of(given.name),
                  .cylinder = shown_.cylinder};
    std::vector<Vec2d> places;
    for (const LinkPlace& place : given.places) places.push_back(place.at);
    part.hull = convex_hull(std::move(places), 0);
    for (const LinkPlace& place : link(kDrivingRod).places) {
      part.on_rod.push_back({kDrivingRod, place.at});
    }
    made_.parts.push_back(std::move(part));
    made_.notes.push_back(
        fmt::format("{} with {} is bought: it is in the bill, and no part is made of it",
                    given.name, link(kDrivingRod).name));
  }

  void add_slots(std::size_t bearer) {
    LinkPart& part = made_.parts[bearer];
    for (const Rail& rail : link(part.link).shape.rails) {
      const LinkShape& traveller = link(rail.traveller);
      part.slots.push_back({traveller.name, rail.from, rail.to, order_.hole + order_.clearance});
      if (order_.block && is_mere_pin(traveller)) add_block(bearer, rail);
    }
    std::erase_if(part.holes, [&](const PartHole& hole) {
      return !hole.pin && std::ranges::any_of(part.slots, [&](const PartSlot& slot) {
        if (!runs_into(slot, hole)) return false;
        made_.notes.push_back(
            fmt::format("the point {} of {} has no hole, as the slot for {} is there", hole.name,
                        part.name, slot.name));
        return true;
      });
    });
  }

  /// The block of a mere pin, and the last slot of its bearer so wide and so much longer that the
  /// corners of the block stay out of the round ends.
  void add_block(std::size_t bearer, const Rail& rail) {
    const LinkShape& slider = link(rail.traveller);
    made_.blocks.push_back({block_part(rail.traveller, slider, order_), bearer});
    PartSlot& slot = made_.parts[bearer].slots.back();
    lengthen(slot, rail, 0.5 * order_.block->x);
    slot.width = order_.block->y + order_.clearance;
  }

  /// Two pins along the first axis of a slider that is a part, and the longer slot for them.
  void add_guide_pins(LinkPart& part) {
    if (!link(part.link).shape.block) return;
    const double aside = guide_pin_distance(part);
    const std::array guides = {PartHole{part.name + " guide 1", {-aside, 0}, true, order_.hole},
                               PartHole{part.name + " guide 2", {aside, 0}, true, order_.hole}};
    part.holes.insert(part.holes.end(), guides.begin(), guides.end());
    for (LinkPart& bearer : made_.parts) {
      for (std::size_t i = 0; i < bearer.slots.size(); ++i) {
        const Rail& rail = link(bearer.link).shape.rails[i];
        if (rail.traveller != part.link) continue;
        lengthen(bearer.slots[i], rail, aside);
        for (const PartHole& guide : guides) {
          made_.pins.push_back(
              {guide.name, {part.link, guide.at}, {part_of(part.link), part_of(bearer.link)}});
          sort_parts(made_.pins.back());
        }
      }
    }
  }

  double guide_pin_distance(const LinkPart& part) const {
    constexpr int kMostTries = 8;
    for (int i = 1; i <= kMostTries; ++i) {
      const double aside = i * order_.width;
      if (!is_close({-aside, 0}, part, order_) && !is_close({aside, 0}, part, order_)) return aside;
    }
    return order_.width;
  }

  static void lengthen(PartSlot& slot, const Rail& rail, double by) {
    const Vec2d way = rail.to - rail.from;
    const double length = norm(way);
    const Vec2d direction = length > 0 ? (1 / length) * way : Vec2d{1, 0};
    slot.from = rail.from - by * direction;
    slot.to = rail.to + by * direction;
  }

  void add_hull(LinkPart& part) {
    if (part.cylinder) return;
    std::vector<Vec2d> points;
    for (const PartHole& hole : part.holes) points.push_back(hole.at);
    for (const PartSlot& slot : part.slots) points.insert(points.end(), {slot.from, slot.to});
    double reach = 0;
    for (const Vec2d& point : points) reach = std::max(reach, norm(point));
    part.hull = convex_hull(std::move(points), kOnePlace * reach);
  }

  /// The parts that a joint's pin goes through: those that it connects, and for a mere pin the
  /// links in whose slots it runs.
  std::vector<int> parts_at(const JointShape& joint) const {
    std::vector<int> parts;
    for (const int number : {joint.first, joint.second}) {
      if (part_of(number) >= 0) {
        parts.push_back(part_of(number));
        continue;
      }
      for (const LinkPart& bearer : made_.parts) {
        const auto& rails = link(bearer.link).shape.rails;
        const bool bears =
            std::ranges::any_of(rails, [&](const Rail& rail) { return rail.traveller == number; });
        if (bears) parts.push_back(part_of(bearer.link));
      }
    }
    return parts;
  }

  /// One pin for each name of turning joints: joints at one place share it.
  void add_joint_pins() {
    for (const JointShape& joint : shown_.joints) {
      if (joint.type == JointType::prismatic) continue;
      auto pin = std::ranges::find(made_.pins, joint.name, &PartPin::name);
      if (pin == made_.pins.end()) {
        made_.pins.push_back({joint.name, joint.at, {}});
        pin = made_.pins.end() - 1;
      }
      const auto through = parts_at(joint);
      pin->parts.insert(pin->parts.end(), through.begin(), through.end());
    }
    for (PartPin& pin : made_.pins) sort_parts(pin);
  }

  static void sort_parts(PartPin& pin) {
    std::ranges::sort(pin.parts);
    const auto [first, last] = std::ranges::unique(pin.parts);
    pin.parts.erase(first, last);
  }

  /// A pin is fast in the first of its parts with a hole for it; the others turn on bearings.
  void seat_bearings() {
    for (PartPin& pin : made_.pins) {
      bool fast = false;
      for (const int number : pin.parts) {
        auto& holes = made_.parts[static_cast<std::size_t>(number)].holes;
        const auto hole = std::ranges::find(holes, pin.name, &PartHole::name);
        if (hole == holes.end()) continue;
        if (fast) hole->diameter = order_.bearing->outside;
        if (fast) ++pin.bearings;
        fast = true;
      }
    }
  }

  const LinkShapes& shown_;
  const PartOrder& order_;
  std::vector<int> part_of_;  ///< of each link; −1 of a mere pin
  LinkParts made_;
};

double widest_hole(const PartOrder& order) {
  return order.bearing ? order.bearing->outside : order.hole;
}

/// Bearings of the same bore that leave something about them, in the order's lengths.
std::string slimmer_words(const PartOrder& order) {
  const Bearing& wanted = *order.bearing;
  const double unit = wanted.outside / bearing_called(wanted.designation)->outside;
  std::string text;
  for (const Bearing& other : slimmer_bearings(*bearing_called(wanted.designation))) {
    text += fmt::format("{}{} with {:.6g}", text.empty() ? "; of the same bore are " : ", ",
                        other.designation, unit * other.outside);
  }
  return text.empty() ? "; none of this bore is slimmer" : text;
}

/// Why a sheet would be so large that places on it have no digits left for holes.
std::optional<std::string> too_large(const PartOrder& order) {
  constexpr double kMostHoles = 1e9;
  const Vec2d sheet = order.sheet.value_or(Vec2d{});
  for (const auto& [option, length] :
       {std::pair("--width", order.width), std::pair("--gap", order.gap.value_or(0)),
        std::pair("--sheet", std::max(sheet.x, sheet.y))}) {
    if (length <= kMostHoles * order.hole) continue;
    return fmt::format("{}: {:.6g} is too large beside holes of {:.6g}; allowed is at most {:.6g}",
                       option, length, order.hole, kMostHoles * order.hole);
  }
  return std::nullopt;
}

/// Why no part can be cut to these sizes.
std::optional<std::string> impossible(const PartOrder& order) {
  const double width = order.narrowest();
  if (order.bearing && !(widest_hole(order) < width)) {
    return fmt::format(
        "--width: {:.6g} leaves nothing about the bearing {} with the outside diameter {:.6g}; "
        "allowed is more than that{}",
        width, order.bearing->designation, order.bearing->outside, slimmer_words(order));
  }
  if (!(order.hole + order.clearance < width)) {
    return fmt::format(
        "--clearance: {:.6g} makes slots as wide as the bars; allowed is less than "
        "{:.6g}",
        order.clearance, width - order.hole);
  }
  if (order.washer_outside > 0 && !(order.hole < order.washer_outside)) {
    return fmt::format(
        "--hole: washers of {:.6g} fall through holes of {:.6g}; allowed are smaller holes",
        order.washer_outside, order.hole);
  }
  if (const auto why = impossible_block(order)) return why;
  if (!(order.kerf < order.hole)) {
    return fmt::format(
        "--kerf: {:.6g} leaves nothing of holes of {:.6g}; allowed is less than that", order.kerf,
        order.hole);
  }
  return too_large(order);
}

/// The first two holes of a part that overlap.
std::optional<std::string> overlap(const LinkPart& part, const PartOrder& order) {
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    for (std::size_t k = i + 1; k < part.holes.size(); ++k) {
      const PartHole &a = part.holes[i], &b = part.holes[k];
      const double distance = norm(b.at - a.at);
      if (distance > 0.5 * (a.diameter + b.diameter)) continue;
      return fmt::format(
          "{}: the holes {} and {} of {} are {:.6g} apart and would overlap; allowed is less than "
          "that{}",
          order.bearing ? "--bearing" : "--hole", a.name, b.name, part.name, distance,
          order.bearing ? " as the mean of their diameters" : "");
    }
  }
  return std::nullopt;
}

void note_slots_over_holes(const LinkPart& part, std::vector<std::string>& notes) {
  for (const PartSlot& slot : part.slots) {
    for (const PartHole& hole : part.holes) {
      if (!runs_into(slot, hole)) continue;
      notes.push_back(
          fmt::format("the slot of {} for {} runs into its hole {}: no flat part can "
                      "have both",
                      part.name, slot.name, hole.name));
    }
  }
}

void note_thin_walls(const LinkPart& part, const PartOrder& order,
                     std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    for (std::size_t k = i + 1; k < part.holes.size(); ++k) {
      const PartHole &a = part.holes[i], &b = part.holes[k];
      const double wall = norm(b.at - a.at) - 0.5 * (a.diameter + b.diameter);
      if (!is_thin(wall, order)) continue;
      notes.push_back(
          fmt::format("the wall between the holes {} and {} of {} is {:.3g} thick, less than a "
                      "tenth of the hole: it may break",
                      a.name, b.name, part.name, wall));
    }
  }
}

void note_thin_rims(const PartOrder& order, std::vector<std::string>& notes) {
  const double rim = 0.5 * (order.narrowest() - widest_hole(order));
  if (!is_thin(rim, order)) return;
  notes.push_back(
      fmt::format("the rim about every hole is {:.3g} thick, less than a tenth of the hole: it may "
                  "break",
                  rim));
}

}  // namespace

double PartOrder::width_of(const std::string& link) const {
  const auto own = std::ranges::find(widths, link, &problems::LinkWidth::link);
  return own == widths.end() ? width : own->width;
}

double PartOrder::narrowest() const {
  double least = width;
  for (const problems::LinkWidth& own : widths) least = std::min(least, own.width);
  return least;
}

bool is_thin(double wall, const PartOrder& order) {
  constexpr double kThinWall = 0.1;  // of a hole
  return wall > 0 && wall < kThinWall * order.hole * (1 - 1e-12);
}

tl::expected<LinkParts, std::string> link_parts(const LinkShapes& shown, const PartOrder& order) {
  if (const auto why = impossible(order)) return tl::unexpected(*why);
  LinkParts made = PartsMaker(shown, order).make();
  for (const LinkPart& part : made.parts) {
    if (const auto why = overlap(part, order)) return tl::unexpected(*why);
    note_slots_over_holes(part, made.notes);
    note_thin_walls(part, order, made.notes);
  }
  note_thin_rims(order, made.notes);
  note_blocks(made, order);
  return made;
}

}  // namespace cognate::app
