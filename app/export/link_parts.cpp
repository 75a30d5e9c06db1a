#include "app/export/link_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/numbers/convex_hull.hpp"
#include "analysis/numbers/segment.hpp"

namespace cognate::app {
namespace {

constexpr double kThinWall = 0.1;  // of a hole

/// A slider that carries nothing but its joint.
bool is_mere_pin(const LinkShape& link) {
  return link.shape.block && link.shape.rails.empty() && link.places.size() <= 1;
}

bool is_close(const Vec2d& p, const LinkPart& part, double distance) {
  return std::ranges::any_of(part.holes,
                             [&](const PartHole& hole) { return norm(hole.at - p) < distance; }) ||
         std::ranges::any_of(part.slots, [&](const PartSlot& slot) {
           return distance_to_segment(p, slot.from, slot.to) < distance;
         });
}

bool runs_into(const PartSlot& slot, const PartHole& hole, const PartOrder& order) {
  return distance_to_segment(hole.at, slot.from, slot.to) <= order.hole + 0.5 * order.clearance;
}

class PartsMaker {
 public:
  PartsMaker(const LinkShapes& shown, const PartOrder& order)
      : shown_(shown), order_(order), part_of_(shown.links.size(), -1) {}

  LinkParts make() {
    for (std::size_t i = 0; i < shown_.links.size(); ++i) add_part(static_cast<int>(i));
    // The guide pins of a slider, which lengthen the slot, keep off its own slots.
    for (LinkPart& part : made_.parts) add_slots(part);
    for (LinkPart& part : made_.parts) add_guide_pins(part);
    for (LinkPart& part : made_.parts) add_hull(part);
    add_joint_pins();
    return std::move(made_);
  }

 private:
  const LinkShape& link(int number) const { return shown_.links[static_cast<std::size_t>(number)]; }
  int part_of(int number) const { return part_of_[static_cast<std::size_t>(number)]; }

  void add_part(int number) {
    const LinkShape& given = link(number);
    if (number > 0 && is_mere_pin(given)) {
      made_.notes.push_back(
          fmt::format("{} is no part but the pin that runs in a slot", given.name));
      return;
    }
    part_of_[static_cast<std::size_t>(number)] = static_cast<int>(made_.parts.size());
    LinkPart part{number, given.name, {}, {}, {}};
    for (const LinkPlace& place : given.places)
      part.holes.push_back({place.name, place.at, place.joint});
    made_.parts.push_back(std::move(part));
  }

  void add_slots(LinkPart& part) {
    for (const Rail& rail : link(part.link).shape.rails) {
      part.slots.push_back({link(rail.traveller).name, rail.from, rail.to});
    }
    std::erase_if(part.holes, [&](const PartHole& hole) {
      return !hole.pin && std::ranges::any_of(part.slots, [&](const PartSlot& slot) {
        return runs_into(slot, hole, order_);
      });
    });
  }

  /// Two pins along the first axis of a slider that is a part, and the longer slot for them.
  void add_guide_pins(LinkPart& part) {
    if (!link(part.link).shape.block) return;
    const double aside = guide_pin_distance(part);
    const std::array guides = {PartHole{part.name + " guide 1", {-aside, 0}},
                               PartHole{part.name + " guide 2", {aside, 0}}};
    part.holes.insert(part.holes.end(), guides.begin(), guides.end());
    for (LinkPart& bearer : made_.parts) {
      for (std::size_t i = 0; i < bearer.slots.size(); ++i) {
        const Rail& rail = link(bearer.link).shape.rails[i];
        if (rail.traveller != part.link) continue;
        lengthen(bearer.slots[i], rail, aside);
        for (const PartHole& guide : guides) {
          made_.pins.push_back(
              {guide.name, {part.link, guide.at}, {part_of(part.link), part_of(bearer.link)}});
        }
      }
    }
  }

  double guide_pin_distance(const LinkPart& part) const {
    constexpr int kMostTries = 8;
    const double apart = order_.hole + order_.clearance;
    for (int i = 1; i <= kMostTries; ++i) {
      const double aside = i * order_.width;
      if (!is_close({-aside, 0}, part, apart) && !is_close({aside, 0}, part, apart)) return aside;
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
    for (PartPin& pin : made_.pins) {
      std::ranges::sort(pin.parts);
      const auto [first, last] = std::ranges::unique(pin.parts);
      pin.parts.erase(first, last);
    }
  }

  const LinkShapes& shown_;
  const PartOrder& order_;
  std::vector<int> part_of_;  ///< of each link; −1 of a mere pin
  LinkParts made_;
};

/// The first two holes of a part that overlap.
std::optional<std::string> overlap(const LinkPart& part, const PartOrder& order) {
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    for (std::size_t k = i + 1; k < part.holes.size(); ++k) {
      const PartHole &a = part.holes[i], &b = part.holes[k];
      const double distance = norm(b.at - a.at);
      if (distance > order.hole) continue;
      return fmt::format(
          "--hole: the holes {} and {} of {} are {:.6g} apart and would overlap; allowed is less "
          "than that",
          a.name, b.name, part.name, distance);
    }
  }
  return std::nullopt;
}

void note_slots_over_holes(const LinkPart& part, const PartOrder& order,
                           std::vector<std::string>& notes) {
  for (const PartSlot& slot : part.slots) {
    for (const PartHole& hole : part.holes) {
      if (!runs_into(slot, hole, order)) continue;
      notes.push_back(
          fmt::format("the slot of {} for {} runs into its hole {}: no flat part can "
                      "have both",
                      part.name, slot.name, hole.name));
    }
  }
}

bool is_thin(double wall, const PartOrder& order) {
  return wall > 0 && wall < kThinWall * order.hole * (1 - 1e-12);
}

void note_thin_walls(const LinkPart& part, const PartOrder& order,
                     std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    for (std::size_t k = i + 1; k < part.holes.size(); ++k) {
      const PartHole &a = part.holes[i], &b = part.holes[k];
      const double wall = norm(b.at - a.at) - order.hole;
      if (!is_thin(wall, order)) continue;
      notes.push_back(
          fmt::format("the wall between the holes {} and {} of {} is {:.3g} thick, less than a "
                      "tenth of the hole: it may break",
                      a.name, b.name, part.name, wall));
    }
  }
}

void note_thin_rims(const PartOrder& order, std::vector<std::string>& notes) {
  const double rim = 0.5 * (order.width - order.hole);
  if (!is_thin(rim, order)) return;
  notes.push_back(
      fmt::format("the rim about every hole is {:.3g} thick, less than a tenth of the hole: it may "
                  "break",
                  rim));
}

}  // namespace

tl::expected<LinkParts, std::string> link_parts(const LinkShapes& shown, const PartOrder& order) {
  LinkParts made = PartsMaker(shown, order).make();
  for (const LinkPart& part : made.parts) {
    if (const auto why = overlap(part, order)) return tl::unexpected(*why);
    note_slots_over_holes(part, order, made.notes);
    note_thin_walls(part, order, made.notes);
  }
  note_thin_rims(order, made.notes);
  return made;
}

PlanOutline rounded_outline(const std::string& layer, const std::vector<Vec2d>& hull,
                            double distance) {
  PlanOutline outline{layer, {}, true};
  const std::size_t count = hull.size();
  if (count < 2) return outline;
  const auto along = [&](std::size_t i) {
    const Vec2d way = hull[(i + 1) % count] - hull[i % count];
    return (1 / norm(way)) * way;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2d here = along(i), next = along(i + 1);
    const Vec2d out = (-distance) * perp(here);
    // The turn from one side to the next is half a turn at most: an arc about the corner.
    double turn = std::atan2(cross(here, next), dot(here, next));
    if (turn < 0) turn = -turn;
    outline.corners.push_back({hull[i] + out});
    outline.corners.push_back({hull[(i + 1) % count] + out, std::tan(turn / 4)});
  }
  return outline;
}

}  // namespace cognate::app
