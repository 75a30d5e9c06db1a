#include "app/export/parts/part_layers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "analysis/layers/collisions.hpp"
#include "analysis/layers/stacking.hpp"
#include "problems/basics/enumeration.hpp"

namespace cognate::app {
namespace {

constexpr int kMostTrials = 200'000;
constexpr std::size_t kMostStackedPins = 64;

using Table = std::vector<std::vector<char>>;

/// What cannot share a layer.
struct PartConflicts {
  Table parts;     ///< whether two parts are joined or collide
  Table pins;      ///< whether a pin meets a part that it does not go through
  Table pin_pins;  ///< whether two pins meet
  std::vector<std::string> unresolved;
};

Table table_of(std::size_t rows, std::size_t columns) {
  return Table(rows, std::vector<char>(columns, 0));
}

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Compares all that could be in one layer.
class ConflictFinder {
 public:
  ConflictFinder(const LinkParts& made, const PartOrder& order) : made_(made), apart_(order.apart) {
    for (const LinkPart& part : made.parts) {
      plates_.push_back({part.link, part.hull, part.rim, part.on_rod});
    }
    for (const PartPin& pin : made.pins) {
      plates_.push_back({pin.at.body, {pin.at.at}, 0.5 * order.hole});
    }
    const std::size_t parts = made.parts.size(), pins = made.pins.size();
    found_ = {table_of(parts, parts), table_of(pins, parts), table_of(pins, pins), {}};
    for (const PartPin& pin : made.pins) {
      for (const int a : pin.parts) {
        for (const int b : pin.parts) found_.parts[index(a)][index(b)] = a != b;
      }
    }
  }

  /// Empty where the time was up.
  std::optional<PartConflicts> find(const PartMotion& moving) {
    list_candidates();
    std::vector<PlatePair> pairs;
    for (const auto& [a, b] : candidates_) pairs.push_back({&plates_[a], &plates_[b]});
    const Collisions found =
        find_collisions(moving.mechanism, moving.motion, pairs, apart_, moving.stop);
    if (!found.complete) return std::nullopt;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (found.pairs[i].passage != Passage::free) mark(candidates_[i], found.pairs[i].passage);
    }
    return std::move(found_);
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;  ///< of plates, pins after the parts

  bool is_pin(std::size_t plate) const { return plate >= made_.parts.size(); }
  std::size_t pin_of(std::size_t plate) const { return plate - made_.parts.size(); }

  bool is_candidate(std::size_t a, std::size_t b) const {
    if (plates_[a].corners.empty() || plates_[b].corners.empty()) return false;
    if (is_pin(a)) return true;
    if (!is_pin(b)) return !found_.parts[a][b];
    return !std::ranges::binary_search(made_.pins[pin_of(b)].parts, static_cast<int>(a));
  }

  void list_candidates() {
    for (std::size_t a = 0; a < plates_.size(); ++a) {
      for (std::size_t b = a + 1; b < plates_.size(); ++b) {
        if (is_candidate(a, b)) candidates_.emplace_back(a, b);
      }
    }
  }

  void mark(const Pair& pair, Passage passage) {
    const auto& [a, b] = pair;
    if (is_pin(a)) {
      found_.pin_pins[pin_of(a)][pin_of(b)] = found_.pin_pins[pin_of(b)][pin_of(a)] = 1;
    } else if (is_pin(b)) {
      found_.pins[pin_of(b)][a] = 1;
    } else {
      found_.parts[a][b] = found_.parts[b][a] = 1;
    }
    if (passage == Passage::unresolved) {
      found_.unresolved.push_back(fmt::format("{} and {}", name(a), name(b)));
    }
  }

  std::string name(std::size_t plate) const {
    return is_pin(plate) ? "the pin " + made_.pins[pin_of(plate)].name : made_.parts[plate].name;
  }

  const LinkParts& made_;
  double apart_;
  std::vector<Plate> plates_;
  std::vector<Pair> candidates_;
  PartConflicts found_;
};

/// The parts but the frame as links of a stack; empty where they are too many.
std::optional<StackProblem> stack_above_frame(const LinkParts& made,
                                              const PartConflicts& conflicts) {
  const std::size_t links = made.parts.size() - 1, pins = made.pins.size();
  if (links > kMostStackedLinks || pins > kMostStackedPins) return std::nullopt;
  const auto set_of = [&](const std::vector<char>& row) {
    LinkSet set = 0;
    for (std::size_t i = 1; i < row.size(); ++i) set |= row[i] ? LinkSet{1} << (i - 1) : 0;
    return set;
  };
  StackProblem problem;
  for (std::size_t i = 1; i <= links; ++i) problem.apart.push_back(set_of(conflicts.parts[i]));
  for (std::size_t p = 0; p < pins; ++p) {
    StackPin pin{.stops_at = set_of(conflicts.pins[p])};
    for (const int part : made.pins[p].parts) {
      if (part == 0) pin.on_base = true;
      if (part > 0) pin.links |= LinkSet{1} << (part - 1);
    }
    for (std::size_t q = 0; q < pins; ++q) {
      if (conflicts.pin_pins[p][q]) pin.pins_hit |= std::uint64_t{1} << q;
    }
    problem.pins.push_back(pin);
  }
  return problem;
}

/// Tries layers part by part.
class LayerAssignment {
 public:
  LayerAssignment(const LinkParts& made, const PartConflicts& meetings)
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

  /// A pin and what it meets between the layers of the parts that it connects: a part, or a pin in
  /// the place of a part after all parts.
  std::optional<std::pair<std::size_t, std::size_t>> first_blocked() const {
    for (std::size_t p = 0; p < made_.pins.size(); ++p) {
      const auto [low, high] = span(p);
      for (std::size_t i = 0; i < layers_.size(); ++i) {
        if (meetings_.pins[p][i] && low < layers_[i] && layers_[i] < high) return std::pair(p, i);
      }
      for (std::size_t q = 0; q < p; ++q) {
        if (!meetings_.pin_pins[p][q]) continue;
        const auto [other_low, other_high] = span(q);
        if (std::max(low, other_low) <= std::min(high, other_high)) {
          return std::pair(p, layers_.size() + q);
        }
      }
    }
    return std::nullopt;
  }

 private:
  /// The lowest and the highest layer of the parts of a pin that have one, ascending where there
  /// are some.
  std::pair<int, int> span(std::size_t pin) const {
    int low = static_cast<int>(layers_.size()), high = -1;
    for (const int part : made_.pins[pin].parts) {
      const int layer = layers_[index(part)];
      if (layer < 0) continue;
      low = std::min(low, layer);
      high = std::max(high, layer);
    }
    return {low, high};
  }

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
  const PartConflicts& meetings_;
  std::vector<int> layers_;
  int trials_ = 0;
};

/// Why nothing can be stacked on the frame.
std::string blocked_note(const LinkParts& made, const StackProblem& problem, LinkSet blocked) {
  std::vector<std::string> names, meetings;
  for (std::size_t i = 1; i < made.parts.size(); ++i) {
    if (blocked >> (i - 1) & 1) names.push_back(made.parts[i].name);
  }
  for (std::size_t p = 0; p < made.pins.size(); ++p) {
    if (!(problem.pins[p].links & blocked)) continue;
    for (std::size_t i = 1; i < made.parts.size(); ++i) {
      if (problem.pins[p].stops_at & blocked & LinkSet{1} << (i - 1)) {
        meetings.push_back(
            fmt::format("the pin {} meets {}", made.pins[p].name, made.parts[i].name));
      }
    }
  }
  return fmt::format(
      "with the frame below all links no number of layers suffices: {} block each "
      "other in every order{}",
      problems::enumeration(names), meetings.empty() ? "" : ": " + problems::enumeration(meetings));
}

/// Tries layers with the frame in any of them.
void stack_with_frame_between(const LinkParts& made, const PartConflicts& conflicts,
                              PartLayers& found) {
  LayerAssignment stacker(made, conflicts);
  const int parts = static_cast<int>(made.parts.size());
  for (int count = 1; count <= parts && found.layers.empty() && !stacker.gave_up(); ++count) {
    found.layers = stacker.stack(count);
  }
  if (!found.layers.empty()) return;
  found.layers = stacker.stack_without_pins();
  const auto blocked = stacker.first_blocked();
  if (!blocked) return;
  const auto& [pin, meets] = *blocked;
  const std::size_t count = made.parts.size();
  found.notes.push_back(
      fmt::format("no stack of layers was found in which every pin passes all other parts: "
                  "somewhere on the way "
                  "the pin {} meets the {} {} between those that it connects",
                  made.pins[pin].name, meets < count ? "part" : "pin",
                  meets < count ? made.parts[meets].name : made.pins[meets - count].name));
}

}  // namespace

tl::expected<PartLayers, std::string> part_layers(const PartMotion& moving, const LinkParts& made,
                                                  const PartOrder& order) {
  const auto conflicts = ConflictFinder(made, order).find(moving);
  if (!conflicts) {
    return tl::unexpected(std::string(
        "--time-limit: came before the collisions of the parts were known; allowed is more time"));
  }
  PartLayers found;
  if (!conflicts->unresolved.empty()) {
    found.notes.push_back(
        "parts that come so near that it cannot be decided whether they collide "
        "are kept in different layers: " +
        problems::enumeration(conflicts->unresolved));
  }
  if (const auto problem = stack_above_frame(made, *conflicts)) {
    const Stack stack = fewest_layers(*problem);
    found.fewest = !stack.layers.empty() || made.parts.size() == 1;
    if (found.fewest) found.layers.push_back(0);
    found.layers.insert(found.layers.end(), stack.layers.begin(), stack.layers.end());
    if (!found.fewest) found.notes.push_back(blocked_note(made, *problem, stack.blocked));
  }
  if (!found.fewest) stack_with_frame_between(made, *conflicts, found);
  for (int& layer : found.layers) ++layer;
  found.count = *std::ranges::max_element(found.layers);
  return found;
}

}  // namespace cognate::app
