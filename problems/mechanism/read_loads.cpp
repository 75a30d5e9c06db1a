#include <fmt/core.h>

#include <optional>

#include "problems/mechanism/quantity_rules.hpp"
#include "problems/mechanism/read_links.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::size_t kMostLoads = 2000;

// Where the load acts: a point, or `at` in the axes of a body or of two points.
std::optional<Attached<double>> read_place(TableReader& load, const PartNames& names) {
  constexpr std::string_view kOn = "on";
  if (!load.has(kOn)) {
    load.fault(kOn, "is missing; expected a point, the name of a body or two of its points");
    return std::nullopt;
  }
  const auto mentions = read_mentions(load, kOn, {1, 2, "names"});
  const auto at = load.two("at", kQuantity, "[u, v]");
  if (!mentions) return std::nullopt;
  const std::string& name = mentions->front().name;
  const auto index = mentions->size() == 1 ? names.point(name) : std::nullopt;
  if (index && !names.body(name)) {
    const PointOnLink& point = names.parts().points[*index];
    if (load.has("at")) {
      load.fault("at", fmt::format("is given for the point {}; expected it for a body or between "
                                   "two points only",
                                   in_quotes(point.name)));
    }
    return bearer(names.parts(), point);
  }
  const auto axes = find_axes(names, *mentions, load.faults());
  if (!axes) return std::nullopt;
  const Vec2d place = at ? Vec2d{(*at)[0], (*at)[1]} : Vec2d{};
  return Attached<double>{axes->body, axes->origin + axes->direction * place};
}

void read_force(TableReader& load, LoadRule& rule) {
  const Two force = load.two("force", kQuantity, "[fx, fy]").value_or(Two{});
  rule.force = {force[0], force[1]};
  rule.torque = load.number("torque", kQuantity).value_or(0);
  if (!load.has("force") && !load.has("torque")) {
    load.fault("force", "is missing; expected a force [fx, fy], a torque, or both");
  }
}

void read_when(TableReader& load, bool slides, LoadRule& rule) {
  constexpr std::string_view kWhen = "when";
  if (!load.has(kWhen)) return;
  if (load.has_text(kWhen)) {
    rule.sense = load.choice<LoadSense>(kWhen).value_or(LoadSense::always);
    return;
  }
  const auto ends = slides ? load.two(kWhen, kQuantity, "[from, to]")
                           : load.two(kWhen, kAngle,
                                      "\"always\", \"advance\", \"return\" or an "
                                      "interval [from_deg, to_deg] of the crank");
  if (!ends) return;
  const auto [from, to] = *ends;
  if (from == to || (slides && from > to)) {
    load.fault(kWhen,
               fmt::format("is an interval from {} to {}; expected one that holds more than a "
                           "position",
                           from, to));
    return;
  }
  rule.between = slides ? std::pair(from, to) : std::pair(radians(from), radians(to));
}

void read_stroke(TableReader& load, LoadRule& rule) {
  constexpr std::string_view kStroke = "stroke";
  const auto part = load.two(kStroke, kShare, "[from, to]");
  if (!part) return;
  if ((*part)[0] >= (*part)[1]) {
    load.fault(kStroke, "is empty; expected fractions [from, to] of the stroke with from < to");
    return;
  }
  rule.within_stroke = std::pair((*part)[0], (*part)[1]);
}

}  // namespace

std::optional<LoadRule> read_load(TableReader& load, const PartNames& names, bool slides) {
  LoadRule rule;
  const auto place = read_place(load, names);
  read_force(load, rule);
  read_when(load, slides, rule);
  read_stroke(load, rule);
  if (!place) return std::nullopt;
  if (place->body == 0) {
    load.fault("on",
               "is a point of the frame, where a load does nothing; expected a point of a moving "
               "body");
  }
  rule.at = *place;
  return rule;
}

std::vector<TableReader> load_tables(TableReader& table) {
  return table.tables("load", {0, kMostLoads, "loads"});
}

std::vector<LoadRule> read_loads(TableReader& table, const PartNames& names, bool slides) {
  std::vector<LoadRule> loads;
  for (TableReader& load : load_tables(table)) {
    const auto rule = read_load(load, names, slides);
    load.finish();
    if (rule) loads.push_back(*rule);
  }
  return loads;
}

}  // namespace cognate::problems::reading
