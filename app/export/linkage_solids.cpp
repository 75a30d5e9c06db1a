#include <algorithm>
#include <array>
#include <utility>

#include "app/export/export_solids.hpp"
#include "app/export/offset_outline.hpp"

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
    for (std::size_t i = 0; i < parts_.made.parts.size(); ++i) add_plate(i);
    for (const PartPin& pin : parts_.made.pins) add_pin(pin);
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
      const double half = 0.5 * (parts_.order.hole + parts_.order.clearance);
      solid.holes.push_back({rounded_loop(way, half), low, high});
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

  void add_pin(const PartPin& pin) {
    const PinStack stack = pin_stack(pin, parts_.layers);
    if (stack.low == 0) return;
    Solid solid{.name = "pin " + pin.name, .at = placed(pin.at)};
    solid.material.push_back(
        {circle_loop({}, 0.5 * parts_.order.hole), low_of(stack.low), high_of(stack.high)});
    solids_.push_back(std::move(solid));
  }

  /// A ring about the pin, its height about the middle of a layer.
  void add_ring(const std::string& name, const PartPin& pin, int layer,
                const std::array<double, 3>& sizes) {
    const auto [outside, bore, width] = sizes;
    const double middle = low_of(layer) + 0.5 * thickness();
    const double low = middle - 0.5 * width, high = middle + 0.5 * width;
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
      for (const int layer : row.layers) {
        add_ring("spacer " + row.name, *pin, layer, {*row.outside, *row.bore, thickness()});
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
