#include "problems/mechanism/read_cylinder.hpp"

#include <fmt/core.h>

#include <array>
#include <utility>
#include <vector>

#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kBaseKey = "at", kPivotKey = "about", kPinKey = "pin";
constexpr std::string_view kLinkKey = "length", kThreeNames = "names";

/// The place of the pivot of the frame that `key` names.
std::optional<Vec2d> read_pivot_of(TableReader& table, std::string_view key, Chain& chain,
                                   std::string& name) {
  const auto given = require_name(table, key,
                                  key == kBaseKey ? "the pivot that the cylinder turns about"
                                                  : "the pivot that the link turns about");
  if (!given) return std::nullopt;
  name = *given;
  chain.used.push_back(name);
  const auto point = find_point(chain.names, *read_mention(table, key), table.faults());
  if (!point) return std::nullopt;
  return chain.names.parts().points[*point].on.front().at;
}

/// Those of rod, cylinder and link.
std::optional<std::vector<Mention>> read_three_names(TableReader& table,
                                                     const CylinderDescription& cylinder) {
  if (!table.has(kThreeNames)) {
    const bool letters = cylinder.about.size() == 1 && cylinder.pin.size() == 1;
    const std::string link = cylinder.about + (letters ? "" : "-") + cylinder.pin;
    const Where where = table.where();
    const std::string called = table.name(kThreeNames);
    return std::vector<Mention>{
        {"rod", where, called}, {"cylinder", where, called}, {link, where, called}};
  }
  auto names = read_mentions(table, kThreeNames, {3, 3, "names, of rod, cylinder and link"});
  if (!names) return std::nullopt;
  for (const Mention& name : *names) {
    if (!check_name(table, name.where, name.called, name.name)) return std::nullopt;
  }
  return names;
}

void add_parts(TableReader& table, Chain& chain, CylinderDescription& cylinder,
               const std::vector<Mention>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    add_body(chain.names, names[i], false, "", table.faults());
    cylinder.names[i] = names[i].name;
    chain.steady.push_back(std::nullopt);
  }
  chain.names.place(cylinder.at, {2, {}});
  chain.names.place(cylinder.about, {3, {}});
  chain.names.place(cylinder.pin, {3, {cylinder.length, 0}});
  chain.names.place(cylinder.pin, {1, {}});
}

}  // namespace

void read_cylinder(TableReader& table, Chain& chain) {
  CylinderDescription cylinder;
  const std::size_t before = table.faults().size();
  chain.mechanism.drive = DrivingRod<double>{};
  const auto base = read_pivot_of(table, kBaseKey, chain, cylinder.at);
  const auto pivot = read_pivot_of(table, kPivotKey, chain, cylinder.about);
  cylinder.pin = require_name(table, kPinKey, "the pin of its rod").value_or("");
  if (!table.has(kLinkKey)) {
    table.fault(kLinkKey, "is missing; expected the length of the link, from its pivot to the pin");
  }
  cylinder.length = table.number(kLinkKey, kLinkLength).value_or(0);
  cylinder.assembly = table.choice<Assembly>("assembly").value_or(Assembly::open);
  const auto names = read_three_names(table, cylinder);
  table.finish();
  if (base && pivot && squared_norm(*base - *pivot) == 0) {
    table.fault(kPivotKey, fmt::format("is {}, at the place of {}, so that the cylinder's length "
                                       "does not turn the link; expected pivots apart",
                                       in_quotes(cylinder.about), in_quotes(cylinder.at)));
  }
  if (!base || !pivot || !names || table.faults().size() != before) {
    chain.names.incomplete = true;
    return;
  }
  chain.mechanism.dyads.push_back(
      Cylinder<double>{{0, *base}, {0, *pivot}, cylinder.length, cylinder.assembly});
  add_parts(table, chain, cylinder, *names);
  chain.description.drive = std::move(cylinder);
}

}  // namespace cognate::problems::reading
