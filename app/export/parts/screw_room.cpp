#include "app/export/parts/screw_room.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "analysis/layers/collisions.hpp"
#include "app/export/parts/part_bill.hpp"
#include "problems/basics/enumeration.hpp"

namespace cognate::app {
namespace {

/// Levels of a stack: 2·l is layer l, 2·l + 1 the gap above it.
struct Levels {
  int low = 0, high = 0;
};

bool share_level(const Levels& a, const Levels& b) {
  return a.low <= b.high && b.low <= a.high;
}

struct StackBody {
  std::string name;
  int pin = -1;       ///< that it belongs to
  bool ring = false;  ///< a washer, a head or a nut
  Plate plate;
  Levels levels;
};

class RoomFinder {
 public:
  RoomFinder(const LinkParts& made, const PartLayers& layers, const PartOrder& order)
      : made_(made), layers_(layers), order_(order) {
    for (std::size_t i = 0; i < made.parts.size(); ++i) {
      const LinkPart& part = made.parts[i];
      if (part.hull.empty()) continue;
      const int level = 2 * layers.layers[i];
      bodies_.push_back(
          {part.name, -1, false, {part.link, part.hull, part.rim, part.on_rod}, {level, level}});
    }
    for (std::size_t i = 0; i < made.pins.size(); ++i) add_pin(static_cast<int>(i));
  }

  std::vector<std::string> notes(const PartMotion& moving) const {
    std::vector<PlatePair> pairs;
    std::vector<std::string> names, met;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (!could_meet(bodies_[i], bodies_[k])) continue;
        pairs.push_back({&bodies_[i].plate, &bodies_[k].plate});
        names.push_back(fmt::format("{} and {}", bodies_[i].name, bodies_[k].name));
      }
    }
    const Collisions found =
        find_collisions(moving.mechanism, moving.motion, pairs, order_.apart, moving.stop);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool is_new = std::ranges::find(met, names[i]) == met.end();
      if (found.pairs[i].passage != Passage::free && is_new) met.push_back(names[i]);
    }
    if (met.empty()) return {};
    return {
        fmt::format("somewhere on the motion there is no room for {}", problems::enumeration(met))};
  }

 private:
  static bool could_meet(const StackBody& a, const StackBody& b) {
    return (a.ring || b.ring) && a.pin != b.pin && share_level(a.levels, b.levels);
  }

  void add_ring(int pin, const char* what, double diameter, const Levels& levels) {
    const PartPin& of = made_.pins[static_cast<std::size_t>(pin)];
    bodies_.push_back({fmt::format("the {} of {}", what, of.name),
                       pin,
                       true,
                       {of.at.body, {of.at.at}, 0.5 * diameter},
                       levels});
  }

  void add_pin(int number) {
    const PartPin& pin = made_.pins[static_cast<std::size_t>(number)];
    const PinStack stack = pin_stack(pin, layers_);
    if (stack.low == 0) return;
    bodies_.push_back({"the pin " + pin.name,
                       number,
                       false,
                       {pin.at.body, {pin.at.at}, 0.5 * order_.hole},
                       {2 * stack.low, 2 * stack.high}});
    for (const int gap : washer_gaps(pin, made_, layers_, order_)) {
      add_ring(number, "washer", order_.washer_outside, {2 * gap + 1, 2 * gap + 1});
    }
    if (order_.screw) add_ends(number, stack);
  }

  /// Head and nut with the washers under them.
  void add_ends(int pin, const PinStack& stack) {
    const Screw& screw = *order_.screw;
    const int below = 2 * stack.low - 1, above = 2 * stack.high + 1;
    add_ring(pin, "washer", screw.washer_outside, {below, below});
    add_ring(pin, "washer", screw.washer_outside, {above, above});
    add_ring(pin, "head", screw.head_diameter, {below - levels_of(screw.head_height), below - 1});
    const double end = screw_of(stack, order_).beyond;
    add_ring(pin, "nut", 2 / std::numbers::sqrt3 * screw.nut_width,
             {above + 1, above + levels_of(std::max(screw.nut_height, end))});
  }

  /// How many levels beyond a layer's face so much reaches into.
  int levels_of(double height) const {
    const double layer = *order_.thickness + order_.washer;
    return 2 * static_cast<int>(std::ceil(height / layer)) - 1;
  }

  const LinkParts& made_;
  const PartLayers& layers_;
  const PartOrder& order_;
  std::vector<StackBody> bodies_;
};

}  // namespace

std::vector<std::string> screw_room_notes(const PartMotion& moving, const LinkParts& made,
                                          const PartLayers& layers, const PartOrder& order) {
  if (order.washer_outside == 0) return {};
  return RoomFinder(made, layers, order).notes(moving);
}

}  // namespace cognate::app
