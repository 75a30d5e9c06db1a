#include "problems/chain/read_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "problems/basics/degrees.hpp"
#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

using synthesis::LineType;

constexpr std::size_t kMostParts = 40;
const std::string kAnyName;
constexpr std::string_view kSlide = "slide";

bool is_free(TableReader& table, std::string_view key) {
  return table.has_text(key) && *table.text(key) == kFreeDimension;
}

/// Two dimensions, each a number or "free", or "free" for both.
void read_two(TableReader& table, std::string_view key, const NumberRule& rule,
              TopologyLine& line) {
  if (!table.has(key) || is_free(table, key)) return;
  std::vector<bool> is_number;
  const auto values = table.each_number_or(key, kFreeDimension, rule, {2, 2, "numbers"}, is_number);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_number[i]) line.given.at(i) = values[i];
  }
}

void read_assembly(TableReader& table, TopologyLine& line) {
  if (!is_free(table, "assembly")) line.assembly = table.choice<Assembly>("assembly");
}

void read_dimensions(TableReader& table, TopologyLine& line) {
  switch (line.line.type) {
    case LineType::pivot:
    case LineType::attached:
      return read_two(table, "at", kQuantity, line);
    case LineType::crank:
      if (!is_free(table, "length")) line.given[0] = table.number("length", kLinkLength);
      return;
    case LineType::dyad:
      read_two(table, "lengths", kLinkLength, line);
      return read_assembly(table, line);
    case LineType::slider:
      if (!is_free(table, "length")) line.given[0] = table.number("length", kLinkLength);
      return read_assembly(table, line);
    default:
      return;
  }
}

/// The direction and the offset of a slider's guide. Its offset counts from the pivot `through`,
/// where the file names one, on which the guide then lies unless it says more.
TopologyLine read_guide(TableReader& dyad) {
  TopologyLine guide{.line = {LineType::guide}};
  if (!dyad.has(kSlide)) return guide;
  TableReader slide = dyad.table(kSlide);
  if (slide.has("direction_deg") && !is_free(slide, "direction_deg")) {
    guide.given[0] = radians(read_degrees(slide, "direction_deg", 0));
  }
  const bool through_pivot = slide.has("through");
  if (!slide.has("offset")) {
    if (through_pivot) guide.given[1] = 0;
  } else if (!is_free(slide, "offset")) {
    guide.given[1] = slide.number("offset", kQuantity);
  }
  slide.finish();
  return guide;
}

std::string_view part_key(LineType type) {
  constexpr std::string_view kKeys[] = {"pivot", "crank", "dyad", "point", "dyad", "dyad"};
  return kKeys[static_cast<std::size_t>(type)];
}

std::string_view name_key(LineType type) {
  return is_dyad(type) ? "new" : "name";
}

std::vector<std::string_view> names_of(const std::vector<Topology>& topologies, LineType type) {
  std::vector<std::string_view> all;
  for (const Topology& topology : topologies) {
    for (const TopologyLine& line : topology.lines) {
      const bool is_new = std::ranges::find(all, line.name) == all.end();
      if (line.line.type == type && is_new) all.push_back(line.name);
    }
  }
  return all;
}

/// The names that tables of a part may have: dyads and sliders have one kind of table.
std::vector<std::string_view> part_names_of(const std::vector<Topology>& topologies,
                                            LineType type) {
  auto all = names_of(topologies, type);
  if (type == LineType::dyad) {
    std::ranges::copy(names_of(topologies, LineType::slider), std::back_inserter(all));
  }
  return all;
}

/// The type of the lines that `table`, one of those of `part`, is about.
LineType type_of(LineType part, const std::string& name, const std::vector<Topology>& topologies) {
  if (part != LineType::dyad) return part;
  const auto sliders = names_of(topologies, LineType::slider);
  return std::ranges::find(sliders, name) == sliders.end() ? part : LineType::slider;
}

/// What of a known topology only a chain says.
void refuse_structure(TableReader& table, LineType type) {
  constexpr std::array<std::array<std::string_view, 3>, 4> kKeys{
      {{}, {"at", "pin", "name"}, {"type", "joins", "names"}, {"on"}}};
  constexpr std::string_view kWhy =
      "is given of a topology that has its own; remove it, or take mechanism.type = \"chain\"";
  for (const std::string_view key : kKeys.at(static_cast<std::size_t>(type))) {
    if (!key.empty() && table.has(key)) table.fault(key, kWhy);
  }
  if (type != LineType::dyad || !table.has_table(kSlide)) return;
  TableReader slide = table.table(kSlide);
  if (slide.has("through")) slide.fault("through", kWhy);
}

std::string_view dimension_key(LineType type) {
  if (type == LineType::dyad) return "lengths";
  return has_lengths(type) ? "length" : type == LineType::guide ? kSlide : "at";
}

void check_in_bounds(TableReader& table, const TopologyLine& line) {
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [min, max] = line.bounds.at(i);
    const auto& given = line.given.at(i);
    if (!given || (*given >= min && *given <= max)) continue;
    return table.fault(
        dimension_key(line.line.type),
        fmt::format("has {}, outside its bounds; [bounds] allows {} to {}", *given, min, max));
  }
}

/// Gives the lines of the type of `read` called `name` (empty: any) what it has.
void give(TableReader& table, const TopologyLine& read, const std::string& name,
          std::vector<Topology>& topologies) {
  bool checked = false;
  for (Topology& topology : topologies) {
    for (TopologyLine& line : topology.lines) {
      if (line.line.type != read.line.type || (!name.empty() && line.name != name)) continue;
      line.given = read.given;
      line.assembly = read.assembly;
      if (!std::exchange(checked, true)) check_in_bounds(table, line);
    }
  }
}

/// Reads `table` into the lines of `type` called `name` (empty: any).
void read_into(TableReader& table, LineType type, const std::string& name,
               std::vector<Topology>& topologies) {
  TopologyLine read{.line = {type}};
  read_dimensions(table, read);
  give(table, read, name, topologies);
  if (type == LineType::slider) give(table, read_guide(table), guide_name(name), topologies);
  table.finish();
}

/// The name of a point of a topology that has its own, each once.
std::string read_known_name(TableReader& table, LineType type, std::vector<std::string>& seen,
                            const std::vector<Topology>& topologies) {
  const std::string_view key = name_key(type);
  const auto name = require_name(table, key, "the point");
  if (!name) return "-";
  const auto known = part_names_of(topologies, type);
  if (std::ranges::find(known, *name) == known.end()) {
    table.fault(key, fmt::format("is {}, which is no {} of this mechanism.type; expected {}",
                                 in_quotes(*name), part_key(type),
                                 known.empty() ? "none" : quoted_list(known)));
  } else if (std::ranges::find(seen, *name) != seen.end()) {
    table.fault(key,
                fmt::format("is {} a second time; expected each point once", in_quotes(*name)));
  }
  seen.push_back(*name);
  return *name;
}

Range intersection(const Range& a, const Range& b) {
  return {std::max(a.min, b.min), std::min(a.max, b.max)};
}

void narrow(TopologyLine& line, const std::array<Range, 2>& to) {
  for (std::size_t i = 0; i < 2; ++i) line.bounds.at(i) = intersection(line.bounds.at(i), to.at(i));
}

std::array<Range, 2> sides(const Box& box) {
  return {Range{box.min.x, box.max.x}, Range{box.min.y, box.max.y}};
}

/// Of a dyad, or a second pin: a range for each of its lengths.
std::optional<std::array<Range, 2>> read_two_ranges(TableReader& bounds, std::string_view key) {
  const auto rows =
      bounds.twos(key, kLengthLimit, "[[min1, max1], [min2, max2]]", {2, 2, "ranges"});
  if (!rows) return std::nullopt;
  std::array<Range, 2> ranges;
  for (std::size_t i = 0; i < 2; ++i) {
    ranges.at(i) = {rows->at(i)[0], rows->at(i)[1]};
    if (ranges.at(i).min <= ranges.at(i).max && ranges.at(i).max > 0) continue;
    bounds.fault(key, "is empty; expected [[min1, max1], [min2, max2]] with min <= max");
    return std::nullopt;
  }
  return ranges;
}

std::optional<std::array<Range, 2>> read_length_bound(TableReader& bounds, std::string_view key) {
  const auto range = bounds.range(key, kLengthLimit);
  if (range && !(range->max > 0)) {
    bounds.fault(key, "allows no length; expected a maximum above 0");
    return std::nullopt;
  }
  return range ? std::optional(std::array{*range, *range}) : std::nullopt;
}

std::optional<std::array<Range, 2>> read_bound(TableReader& bounds, const std::string& key,
                                               LineType type) {
  if (type == LineType::guide) {
    const auto offset = bounds.range(key, kQuantity);
    return offset ? std::optional(std::array{TopologyLine{}.bounds[0], *offset}) : std::nullopt;
  }
  if (!has_lengths(type)) {
    const auto box = bounds.box(key);
    return box ? std::optional(sides(*box)) : std::nullopt;
  }
  return parameter_count(type) == 2 ? read_two_ranges(bounds, key) : read_length_bound(bounds, key);
}

template <class Accepts>
void narrow_all(std::vector<Topology>& topologies, const Accepts& accepts,
                const std::optional<std::array<Range, 2>>& to) {
  if (!to) return;
  for (Topology& topology : topologies) {
    for (TopologyLine& line : topology.lines) {
      if (accepts(line)) narrow(line, *to);
    }
  }
}

void check_not_empty(TableReader& bounds, const std::string& name,
                     const std::vector<Topology>& topologies) {
  for (const Topology& topology : topologies) {
    for (const TopologyLine& line : topology.lines) {
      const auto is_empty = [](const Range& range) { return range.min > range.max; };
      if (line.name != name || std::ranges::none_of(line.bounds, is_empty)) continue;
      return bounds.fault(name,
                          "leaves nothing of the bounds for all; expected limits within "
                          "them");
    }
  }
}

}  // namespace

PartTables::PartTables(TableReader& document, TableReader& mechanism) {
  const auto tables = [&](std::string_view key, std::string_view of) {
    TableReader& place = holder(key, document, mechanism);
    return place.has(key) ? place.tables(key, {0, kMostParts, of}) : std::vector<TableReader>{};
  };
  pivots = tables("pivot", "pivots");
  dyads = tables("dyad", "dyads");
  points = tables("point", "points");
  TableReader& place = holder("crank", document, mechanism);
  if (place.has("crank")) cranks.push_back(place.table("crank"));
}

std::vector<std::pair<LineType, std::vector<TableReader>*>> PartTables::all() {
  return {{LineType::pivot, &pivots},
          {LineType::crank, &cranks},
          {LineType::dyad, &dyads},
          {LineType::attached, &points}};
}

bool is_three_pin_link(TableReader& dyad) {
  constexpr std::string_view kType = "type";
  return dyad.has_text(kType) && *dyad.text(kType) == kThreePinWord;
}

void read_given(PartTables& parts, std::vector<Topology>& topologies) {
  for (auto& [type, tables] : parts.all()) {
    for (TableReader& table : *tables) {
      if (type == LineType::dyad && is_three_pin_link(table)) {
        table.finish();
        continue;
      }
      const bool is_named = table.has_text(name_key(type));
      const auto name = is_named ? *table.text(name_key(type)) : std::string("-");
      read_into(table, type_of(type, name, topologies), type == LineType::crank ? kAnyName : name,
                topologies);
    }
  }
}

void read_given_by_name(PartTables& parts, std::vector<Topology>& topologies) {
  std::vector<std::string> seen;
  for (auto& [type, tables] : parts.all()) {
    for (TableReader& table : *tables) {
      if (type == LineType::dyad && std::ranges::any_of(topologies, has_three_pin_link)) {
        table.faults().add(table.where(), fmt::format("[[dyad]] {}", kThreePinsAreFound));
        continue;
      }
      refuse_structure(table, type);
      const bool is_crank = type == LineType::crank;
      const auto name = is_crank ? kAnyName : read_known_name(table, type, seen, topologies);
      read_into(table, type_of(type, name, topologies), name, topologies);
    }
  }
}

void read_chain_bounds(TableReader& bounds, std::vector<Topology>& topologies) {
  const auto box = [&](std::string_view key) {
    const auto read = bounds.box(key);
    return read ? std::optional(sides(*read)) : std::nullopt;
  };
  const auto of = [](LineType type) {
    return [type](const TopologyLine& line) { return line.line.type == type; };
  };
  narrow_all(
      topologies, [](const TopologyLine& line) { return has_lengths(line.line.type); },
      read_length_bound(bounds, "length"));
  narrow_all(topologies, of(LineType::pivot), box("pivots"));
  narrow_all(topologies, of(LineType::attached), box("point"));
  for (const LineType type : {LineType::pivot, LineType::crank, LineType::dyad, LineType::attached,
                              LineType::guide, LineType::slider, LineType::third_link,
                              LineType::first_pin, LineType::second_pin, LineType::third_pin}) {
    for (const std::string_view known : names_of(topologies, type)) {
      const std::string name(known);
      if (!bounds.has(name)) continue;
      narrow_all(
          topologies, [&](const TopologyLine& line) { return line.name == name; },
          read_bound(bounds, name, type));
      check_not_empty(bounds, name, topologies);
    }
  }
}

}  // namespace cognate::problems::reading
