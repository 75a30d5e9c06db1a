#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/numbers/hull_distance.hpp"
#include "app/export/part_sheet.hpp"

namespace cognate::app {
namespace {

constexpr int kMostTrials = 200'000;

using Table = std::vector<std::vector<char>>;

/// What meets what on the way of the drive.
struct Overlaps {
  Table parts;  ///< whether two parts overlap
  Table pins;   ///< whether a pin meets a part that it does not go through
};

class MeetingFinder {
 public:
  MeetingFinder(const LinkShapes& shown, const LinkParts& made, const PartOrder& order)
      : shown_(shown), made_(made), order_(order), placed_(made.parts.size()) {
    const std::size_t count = made.parts.size();
    found_.parts.assign(count, std::vector<char>(count, 0));
    found_.pins.assign(made.pins.size(), std::vector<char>(count, 0));
    for (const PartPin& pin : made.pins) {
      for (const int a : pin.parts) {
        for (const int b : pin.parts) found_.parts[index(a)][index(b)] = a != b;
      }
    }
  }

  Overlaps find() {
    for (std::size_t k = 0; k < shown_.poses.size(); ++k) {
      if (place_parts(k)) look_at(k);
    }
    return std::move(found_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// False where the linkage cannot be assembled.
  bool place_parts(std::size_t k) {
    for (std::size_t i = 0; i < made_.parts.size(); ++i) {
      const LinkPart& part = made_.parts[i];
      const BodyTrack& track = shown_.poses.bodies[index(part.link)];
      if (!std::isfinite(track.x[k])) return false;
      placed_[i].clear();
      for (const Vec2d& corner : part.hull) placed_[i].push_back(place(track, k, corner));
    }
    return true;
  }

  void look_at(std::size_t k) {
    for (std::size_t a = 0; a < placed_.size(); ++a) {
      for (std::size_t b = a + 1; b < placed_.size(); ++b) {
        if (found_.parts[a][b] || hull_distance(placed_[a], placed_[b]) > order_.width) continue;
        found_.parts[a][b] = found_.parts[b][a] = 1;
      }
    }
    const double least = 0.5 * (order_.width + order_.hole);
    for (std::size_t p = 0; p < made_.pins.size(); ++p) {
      const PartPin& pin = made_.pins[p];
      const Vec2d at = place(shown_.poses.bodies[index(pin.at.body)], k, pin.at.at);
      for (std::size_t a = 0; a < placed_.size(); ++a) {
        if (std::ranges::binary_search(pin.parts, static_cast<int>(a))) continue;
        if (hull_distance({&at, 1}, placed_[a]) <= least) found_.pins[p][a] = 1;
      }
    }
  }

  const LinkShapes& shown_;
  const LinkParts& made_;
  const PartOrder& order_;
  std::vector<std::vector<Vec2d>> placed_;
  Overlaps found_;
};

/// Tries layers part by part.
class LayerAssignment {
 public:
  LayerAssignment(const LinkParts& made, const Overlaps& meetings)
      : made_(made), meetings_(meetings), layers_(made.parts.size(), -1) {}

  /// The layers, from 0, of a stack of `count`; empty where none was found. The frame is not tried
  /// above the middle: that is the same stack upside down.
  std::vector<int> stack(int count) {
    std::ranges::fill(layers_, -1);
    for (int layer = 0; layer < (count + 1) / 2; ++layer) {
      layers_.front() = layer;
      if (is_placed(1, count)) return layers_;
    }
    return {};
  }

  bool gave_up() const { return trials_ >= kMostTrials; }

  /// Each part in the lowest layer that is free of parts it meets, regardless of what the pins
  /// meet.
  std::vector<int> stack_without_pins() {
    std::ranges::fill(layers_, -1);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      layers_[i] = 0;
      while (!is_free(i)) ++layers_[i];
    }
    return layers_;
  }

  /// A pin and a part that it meets between the layers of those that it connects.
  std::optional<std::pair<std::size_t, std::size_t>> first_blocked() const {
    for (std::size_t p = 0; p < made_.pins.size(); ++p) {
      int low = static_cast<int>(layers_.size()), high = -1;
      for (const int part : made_.pins[p].parts) {
        const int layer = layers_[static_cast<std::size_t>(part)];
        if (layer < 0) continue;
        low = std::min(low, layer);
        high = std::max(high, layer);
      }
      for (std::size_t i = 0; i < layers_.size(); ++i) {
        if (meetings_.pins[p][i] && low < layers_[i] && layers_[i] < high) return std::pair(p, i);
      }
    }
    return std::nullopt;
  }

 private:
  bool is_placed(std::size_t part, int count) {
    if (part >= layers_.size()) return true;
    for (int layer = 0; layer < count && !gave_up(); ++layer) {
      ++trials_;
      layers_[part] = layer;
      if (is_free(part) && pins_are_free() && is_placed(part + 1, count)) return true;
    }
    layers_[part] = -1;
    return false;
  }

  bool is_free(std::size_t part) const {
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (i != part && layers_[i] == layers_[part] && meetings_.parts[part][i]) return false;
    }
    return true;
  }

  bool pins_are_free() const { return !first_blocked(); }

  const LinkParts& made_;
  const Overlaps& meetings_;
  std::vector<int> layers_;
  int trials_ = 0;
};

}  // namespace

PartLayers part_layers(const LinkShapes& shown, const LinkParts& made, const PartOrder& order) {
  const Overlaps meetings = MeetingFinder(shown, made, order).find();
  LayerAssignment stacker(made, meetings);
  PartLayers found;
  const int parts = static_cast<int>(made.parts.size());
  for (int count = 1; count <= parts && found.layers.empty() && !stacker.gave_up(); ++count) {
    found.layers = stacker.stack(count);
  }
  if (found.layers.empty()) {
    found.layers = stacker.stack_without_pins();
    if (const auto blocked = stacker.first_blocked()) {
      found.notes.push_back(fmt::format(
          "no stack of layers was found in which every pin passes all other parts: somewhere on "
          "the way the pin {} meets the part {} between those that it connects",
          made.pins[blocked->first].name, made.parts[blocked->second].name));
    }
  }
  for (int& layer : found.layers) ++layer;
  found.count = *std::ranges::max_element(found.layers);
  return found;
}

}  // namespace cognate::app
