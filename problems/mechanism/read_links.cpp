#include "problems/mechanism/read_links.hpp"

#include <fmt/core.h>

#include <optional>

#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::size_t kMostTables = 2000;

// The axes given by `name` or `between`.
std::optional<Axes> read_link_axes(TableReader& link, const PartNames& names) {
  constexpr std::string_view kName = "name";
  constexpr std::string_view kBetween = "between";
  if (link.has(kName) && link.has(kBetween)) {
    link.fault(kName, fmt::format("is given beside {}; give one of them", link.name(kBetween)));
    return std::nullopt;
  }
  const std::string_view key = link.has(kName) ? kName : kBetween;
  if (!link.has(key)) {
    link.fault(
        kBetween,
        "is missing; expected two points of the body, between = [\"...\", \"...\"], or its name");
    return std::nullopt;
  }
  const auto mentions = read_mentions(link, key, {1, 2, "names"});
  return mentions ? find_axes(names, *mentions, link.faults()) : std::nullopt;
}

Inertia read_inertia(TableReader& link, const Axes& axes, bool slider) {
  constexpr std::string_view kCentre = "centre";
  Inertia inertia;
  inertia.mass = link.number("mass", kMass).value_or(0);
  inertia.moment = link.number("inertia", kMass).value_or(0);
  if (!link.has("mass") && !link.has("inertia")) {
    link.fault(
        "mass",
        "is missing; expected the link's mass, its inertia about the centre of mass, or both");
  }
  if (!link.has(kCentre) && inertia.mass > 0 && !slider) {
    link.fault(kCentre,
               "is missing; expected the centre of mass [u, v] (the origin at the first point "
               "named, the first axis towards the second)");
  }
  const auto centre = link.two(kCentre, kQuantity, "[u, v]");
  if (centre) inertia.centre = axes.origin + axes.direction * Vec2d{(*centre)[0], (*centre)[1]};
  return inertia;
}

void read_link(TableReader& link, const PartNames& names, std::vector<Inertia>& inertias,
               std::vector<bool>& given) {
  const auto axes = read_link_axes(link, names);
  const int body = axes ? axes->body : 0;
  const Inertia inertia =
      read_inertia(link, axes.value_or(Axes{}), names.parts().bodies[body].slider || !axes);
  link.finish();
  if (!axes) return;
  const std::string name = in_quotes(names.parts().bodies[body].name);
  if (body == 0) {
    link.faults().add(link.where(),
                      "[[link]] is the frame, which does not move; expected the mass of a "
                      "moving body");
  } else if (given[body]) {
    link.faults().add(link.where(),
                      fmt::format("[[link]] gives {} a second time; expected one table for "
                                  "each body",
                                  name));
  }
  given[body] = true;
  inertias[body] = inertia;
}

}  // namespace

std::vector<Inertia> read_links(TableReader& table, const PartNames& names) {
  std::vector<Inertia> inertias(names.parts().bodies.size());
  std::vector<bool> given(inertias.size());
  for (TableReader& link : table.tables("link", {0, kMostTables, "links"})) {
    read_link(link, names, inertias, given);
  }
  return inertias;
}

Vec2d read_gravity(TableReader& table) {
  const Two gravity = table.two("gravity", kQuantity, "[x, y]").value_or(Two{});
  return {gravity[0], gravity[1]};
}

}  // namespace cognate::problems::reading
