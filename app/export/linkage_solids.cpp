#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "app/export/export_solids.hpp"
#include "app/export/parts/offset_outline.hpp"

namespace cognate::app {
namespace {

/// At the distance about a polygon, or about a point.
SolidLoop rounded_loop(const std::vector<Vec2d>& hull, double distance) {
  if (hull.size() == 1) return circle_loop(hull.front(), distance);
  return {rounded_outline("", hull, distance).corners};
}

class LinkageSolids {
 public:
  LinkageSolids(const StackedParts& parts, std::span<const BodyMotion<double, 0>> bodies)
      : parts_(parts), bodies_(bodies) {}

  std::vector<Solid> make() {
    for (std::size_t i = 0; i < parts_.made.parts.size(); ++i) {
      if (!parts_.made.parts[i].cylinder) add_plate(i);
    }
    for (const PartPin& pin : parts_.made.pins) {
      const PinStack stack = pin_stack(pin, parts_.layers);
      if (stack.low == 0) continue;
      if (parts_.order.screw) {
        add_screw(pin, stack);
      } else {
        add_pin(pin, stack);
      }
      if (parts_.order.washer_outside > 0) add_washers(pin, stack);
    }
    if (parts_.order.bearing) {
      for (const PartPin& pin : parts_.made.pins) add_bearings(pin);
    }
    if (parts_.order.spacers) add_spacers();
    return std::move(solids_);
  }

 private:
  double thickness() const { return *parts_.order.thickness; }

  double low_of(int layer) const { return (layer - 1) * (thickness() + parts_.order.washer); }

  double high_of(int layer) const { return low_of(layer) + thickness(); }

  Vec2d placed(const Attached<double>& point) const {
    const auto& body = bodies_[static_cast<std::size_t>(point.body)];
    return body.origin[0] + body.direction * point.at;
  }

  /// Of the link, its axes where its body has them.
  void add_plate(std::size_t i) {
    const LinkPart& part = parts_.made.parts[i];
    const int layer = parts_.layers.layers[i];
    const double low = low_of(layer), high = high_of(layer);
    const auto& body = bodies_[static_cast<std::size_t>(part.link)];
    Solid solid{.name = part.name, .at = body.origin[0], .direction = body.direction};
    solid.material.push_back({rounded_loop(part.hull, part.rim), low, high});
    for (const PartHole& hole : part.holes) {
      solid.holes.push_back({circle_loop(hole.at, 0.5 * hole.diameter), low, high});
    }
    for (const PartBoss& boss : parts_.bosses.all) {
      if (boss.part == i) add_boss(boss, layer, solid);
    }
    for (const PartSlot& slot : part.slots) {
      std::vector<Vec2d> way = {slot.from};
      if (norm(slot.to - slot.from) > kOnePlace * norm(slot.from)) way.push_back(slot.to);
      solid.holes.push_back({rounded_loop(way, 0.5 * slot.width), low, high});
    }
    solids_.push_back(std::move(solid));
  }

  /// Up to the washer before the next plate, and with the hole through it.
  void add_boss(const PartBoss& boss, int layer, Solid& solid) const {
    const auto& holes = parts_.made.parts[boss.part].holes;
    const PartHole& hole = *std::ranges::find(holes, boss.pin, &PartHole::name);
    const bool above = boss.next > layer;
    const double low = above ? low_of(layer) : high_of(boss.next) + parts_.order.washer;
    const double high = above ? low_of(boss.next) - parts_.order.washer : high_of(layer);
    solid.material.push_back({circle_loop(hole.at, 0.5 * *parts_.order.boss), low, high});
    solid.holes.push_back({circle_loop(hole.at, 0.5 * hole.diameter), low, high});
  }

  void add_pin(const PartPin& pin, const PinStack& stack) {
    Solid solid{.name = "pin " + pin.name, .at = placed(pin.at)};
    solid.material.push_back(
        {circle_loop({}, 0.5 * parts_.order.hole), low_of(stack.low), high_of(stack.high)});
    solids_.push_back(std::move(solid));
  }

  /// The screw with its head below, without threads, and the nut.
  void add_screw(const PartPin& pin, const PinStack& stack) {
    const Screw& screw = *parts_.order.screw;
    const auto [length, beyond, too_long] = screw_of(stack, parts_.order);
    const double seat = low_of(stack.low) - screw.washer_thickness;
    const double face = high_of(stack.high) + screw.washer_thickness;
    Solid bolt{.name = "screw " + pin.name, .at = placed(pin.at)};
    bolt.material.push_back({circle_loop({}, 0.5 * screw.diameter), seat, seat + length});
    bolt.material.push_back(
        {circle_loop({}, 0.5 * screw.head_diameter), seat - screw.head_height, seat});
    solids_.push_back(std::move(bolt));
    Solid nut{.name = "nut " + pin.name, .at = placed(pin.at)};
    nut.material.push_back({hexagon(screw.nut_width), face, face + screw.nut_height});
    nut.holes.push_back({circle_loop({}, 0.5 * screw.diameter), face, face + screw.nut_height});
    solids_.push_back(std::move(nut));
  }

  static SolidLoop hexagon(double across_flats) {
    constexpr int kSides = 6;
    SolidLoop loop;
    for (int i = 0; i < kSides; ++i) {
      const double angle = i * kTurn / kSides;
      loop.corners.push_back(
          {across_flats / std::numbers::sqrt3 * Vec2d{std::cos(angle), std::sin(angle)}});
    }
    return loop;
  }

  void add_washers(const PartPin& pin, const PinStack& stack) {
    const PartOrder& order = parts_.order;
    std::vector<double> faces;
    if (order.screw) faces = {low_of(stack.low) - order.washer, high_of(stack.high)};
    for (const int gap : washer_gaps(pin, parts_.made, parts_.layers, order)) {
      faces.push_back(high_of(gap));
    }
    const double bore = order.screw ? order.screw->hole : order.hole;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      add_tube(fmt::format("washer {} {}", pin.name, i + 1), pin, faces[i],
               {order.washer_outside, bore, order.washer});
    }
  }

  /// A ring about the pin, its height about the middle of a layer.
  void add_ring(const std::string& name, const PartPin& pin, int layer,
                const std::array<double, 3>& sizes) {
    add_tube(name, pin, low_of(layer) + 0.5 * (thickness() - sizes[2]), sizes);
  }

  /// Outside diameter, bore and height, from the height `low` on.
  void add_tube(const std::string& name, const PartPin& pin, double low,
                const std::array<double, 3>& sizes) {
    const auto [outside, bore, height] = sizes;
    const double high = low + height;
    Solid solid{.name = name, .at = placed(pin.at)};
    solid.material.push_back({circle_loop({}, 0.5 * outside), low, high});
    solid.holes.push_back({circle_loop({}, 0.5 * bore), low, high});
    solids_.push_back(std::move(solid));
  }

  /// In each link whose hole for the pin is as wide as a bearing.
  void add_bearings(const PartPin& pin) {
    const Bearing& bearing = *parts_.order.bearing;
    for (const int number : pin.parts) {
      const auto& part = parts_.made.parts[static_cast<std::size_t>(number)];
      const auto hole = std::ranges::find(part.holes, pin.name, &PartHole::name);
      if (hole == part.holes.end() || hole->diameter != bearing.outside) continue;
      add_ring("bearing " + pin.name + " in " + part.name, pin,
               parts_.layers.layers[static_cast<std::size_t>(number)],
               {bearing.outside, bearing.bore, bearing.width});
    }
  }

  void add_spacers() {
    for (const BillRow& row : parts_.bill.rows) {
      if (row.item != "spacer") continue;
      const auto pin = std::ranges::find(parts_.made.pins, row.name, &PartPin::name);
      for (std::size_t i = 0; i < row.layers.size(); ++i) {
        add_ring(spacer_name(row, i), *pin, row.layers[i], {*row.outside, *row.bore, thickness()});
      }
    }
  }

  const StackedParts& parts_;
  std::span<const BodyMotion<double, 0>> bodies_;
  std::vector<Solid> solids_;
};

}  // namespace

std::vector<Solid> linkage_solids(const StackedParts& parts,
                                  std::span<const BodyMotion<double, 0>> bodies) {
  return LinkageSolids(parts, bodies).make();
}

}  // namespace cognate::app
