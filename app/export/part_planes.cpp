#include "app/export/part_planes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/export/hull_distance.hpp"

namespace cognate::app {
namespace {

constexpr int kMostTrials = 200'000;

using Table = std::vector<std::vector<char>>;

/// What meets what on the way of the drive.
struct Meetings {
  Table parts;  ///< whether two parts overlap
  Table pins;   ///< whether a pin meets a part that it does not go through
};

class MeetingFinder {
 public:
  MeetingFinder(const ShownLinks& shown, const LinkParts& made, const PartOrder& order)
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

  Meetings find() {
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

  const ShownLinks& shown_;
  const LinkParts& made_;
  const PartOrder& order_;
  std::vector<std::vector<Vec2d>> placed_;
  Meetings found_;
};

/// Tries planes part by part.
class Stacker {
 public:
  Stacker(const LinkParts& made, const Meetings& meetings)
      : made_(made), meetings_(meetings), planes_(made.parts.size(), -1) {}

  /// The planes, from 0, of a stack of `count`; empty where none was found. The frame is not tried
  /// above the middle: that is the same stack upside down.
  std::vector<int> stack(int count) {
    std::ranges::fill(planes_, -1);
    for (int plane = 0; plane < (count + 1) / 2; ++plane) {
      planes_.front() = plane;
      if (is_placed(1, count)) return planes_;
    }
    return {};
  }

  bool gave_up() const { return trials_ >= kMostTrials; }

  /// Each part in the lowest plane that is free of parts it meets, whatever the pins meet.
  std::vector<int> stack_without_pins() {
    std::ranges::fill(planes_, -1);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      planes_[i] = 0;
      while (!is_free(i)) ++planes_[i];
    }
    return planes_;
  }

  /// A pin and a part that it meets between the planes of those that it connects.
  std::optional<std::pair<std::size_t, std::size_t>> first_blocked() const {
    for (std::size_t p = 0; p < made_.pins.size(); ++p) {
      int low = static_cast<int>(planes_.size()), high = -1;
      for (const int part : made_.pins[p].parts) {
        const int plane = planes_[static_cast<std::size_t>(part)];
        if (plane < 0) continue;
        low = std::min(low, plane);
        high = std::max(high, plane);
      }
      for (std::size_t i = 0; i < planes_.size(); ++i) {
        if (meetings_.pins[p][i] && low < planes_[i] && planes_[i] < high) return std::pair(p, i);
      }
    }
    return std::nullopt;
  }

 private:
  bool is_placed(std::size_t part, int count) {
    if (part >= planes_.size()) return true;
    for (int plane = 0; plane < count && !gave_up(); ++plane) {
      ++trials_;
      planes_[part] = plane;
      if (is_free(part) && pins_are_free() && is_placed(part + 1, count)) return true;
    }
    planes_[part] = -1;
    return false;
  }

  bool is_free(std::size_t part) const {
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      if (i != part && planes_[i] == planes_[part] && meetings_.parts[part][i]) return false;
    }
    return true;
  }

  bool pins_are_free() const { return !first_blocked(); }

  const LinkParts& made_;
  const Meetings& meetings_;
  std::vector<int> planes_;
  int trials_ = 0;
};

}  // namespace

PartPlanes part_planes(const ShownLinks& shown, const LinkParts& made, const PartOrder& order) {
  const Meetings meetings = MeetingFinder(shown, made, order).find();
  Stacker stacker(made, meetings);
  PartPlanes found;
  const int parts = static_cast<int>(made.parts.size());
  for (int count = 1; count <= parts && found.planes.empty() && !stacker.gave_up(); ++count) {
    found.planes = stacker.stack(count);
  }
  if (found.planes.empty()) {
    found.planes = stacker.stack_without_pins();
    if (const auto blocked = stacker.first_blocked()) {
      found.notes.push_back(fmt::format(
          "no stack of planes was found in which every pin passes all other parts: somewhere on "
          "the way the pin {} meets the part {} between those that it connects",
          made.pins[blocked->first].name, made.parts[blocked->second].name));
    }
  }
  for (int& plane : found.planes) ++plane;
  found.count = *std::ranges::max_element(found.planes);
  return found;
}

}  // namespace cognate::app
