#include "problems/mechanism/read_chain.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "problems/mechanism/drawn/read_drawing.hpp"
#include "problems/mechanism/drawn/read_drawn_chain.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/mechanism/read_chain_dyads.hpp"
#include "problems/mechanism/read_cylinder.hpp"
#include "problems/mechanism/read_group.hpp"
#include "problems/mechanism/read_slides.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::size_t kMostPivots = 1000;
// The assembly ranges of a motion takes time that grows with their square: with 200 some seconds.
constexpr std::size_t kMostDyads = 200;
constexpr std::string_view kCrank = "crank";
constexpr std::string_view kSlider = "slider";
constexpr std::string_view kCylinder = "cylinder";

void announce_name(TableReader& table, std::string_view key, PartNames& names) {
  if (!table.has_text(key)) return;
  announce(names, *read_mention(table, key), table.faults());
}

void read_pivot(TableReader& table, Chain& chain) {
  constexpr std::string_view kName = "name";
  constexpr std::string_view kAt = "at";
  const auto name = require_name(table, kName, "the pivot");
  announce_name(table, kName, chain.names);
  if (!table.has(kAt)) table.fault(kAt, "is missing; expected [x, y]");
  const auto at = table.two(kAt, kQuantity, "[x, y]");
  table.finish();
  if (!name || !at) {
    chain.names.incomplete = true;
    return;
  }
  const Vec2d place{(*at)[0], (*at)[1]};
  chain.description.pivots.push_back({*name, place});
  if (!chain.names.point(*name)) chain.names.place(*name, {0, place});
}

// The bodies and joints of `dyads` dyads and `drives` drives, and the mobility of those by
// Grübler's formula for plane linkages, 3(n − 1) − 2j.
std::string mobility(std::size_t dyads, int drives) {
  const int bodies = 1 + drives + 2 * static_cast<int>(dyads);
  const int joints = drives + 3 * static_cast<int>(dyads);
  return fmt::format("mobility 3(n - 1) - 2j = {} with n = {} bodies and j = {} joints",
                     3 * (bodies - 1) - 2 * joints, bodies, joints);
}

void read_crank(TableReader& table, Chain& chain) {
  constexpr std::string_view kAt = "at";
  constexpr std::string_view kLength = "length";
  CrankDescription crank;
  const std::size_t before = table.faults().size();
  const auto pivot = require_name(table, kAt, "the pivot it turns about");
  crank.at = pivot.value_or("");
  crank.pin = require_name(table, "pin", "its pin").value_or("");
  crank.name = read_name(table, "name").value_or(crank.name);
  if (!table.has(kLength)) table.fault(kLength, "is missing; expected a length");
  crank.length = table.number(kLength, kLinkLength).value_or(0);
  table.finish();
  const auto index =
      pivot ? find_point(chain.names, *read_mention(table, kAt), table.faults()) : std::nullopt;
  if (!index || table.faults().size() != before) {
    chain.names.incomplete = true;
    return;
  }
  chain.used.push_back(crank.at);
  const Vec2d place = chain.names.parts().points[*index].on.front().at;
  chain.mechanism.drive = Crank<double>{place, crank.length};
  chain.names.place(crank.at, {1, {}});
  add_body(chain.names, {crank.name, table.where("name"), table.name("name")}, false, "",
           table.faults());
  chain.names.place(crank.pin, {1, {crank.length, 0}});
  chain.steady.push_back(std::nullopt);
  chain.description.drive = std::move(crank);
}

void read_driving_slider(TableReader& table, Chain& chain) {
  SliderDescription slider;
  const std::size_t before = table.faults().size();
  const auto slide = read_slide_of(table, chain);
  if (slide && slide->guide.body != 0) {
    table.fault("slide", "is on a moving body; a driving slider has its guide on the frame");
  }
  slider.pin = require_name(table, "pin", "its pin").value_or("");
  slider.name = read_name(table, "name").value_or(slider.name);
  table.finish();
  if (!slide || table.faults().size() != before) {
    chain.names.incomplete = true;
    return;
  }
  slider.slide = slide->description;
  chain.mechanism.drive = DrivingSlider<double>{slide->guide};
  add_body(chain.names, {slider.name, table.where("name"), table.name("name")}, true, slider.pin,
           table.faults());
  chain.names.place(slider.pin, {1, {}});
  chain.steady.push_back(slide->guide.direction);
  chain.description.drive = std::move(slider);
}

/// What may drive a chain: its table, and how it is read.
struct DriveTable {
  std::string_view key;
  void (*read)(TableReader& table, Chain& chain);
};
constexpr DriveTable kDrives[] = {
    {kCrank, read_crank}, {kSlider, read_driving_slider}, {kCylinder, read_cylinder}};

void announce_pins(TableReader& document, TableReader& mechanism, PartNames& names) {
  for (const auto& [key, read] : kDrives) {
    TableReader& place = holder(key, document, mechanism);
    if (!place.has_table(key)) continue;
    TableReader table = place.table(key);
    announce_name(table, "pin", names);
  }
}

void read_drive(TableReader& document, TableReader& mechanism, std::size_t dyads, Chain& chain) {
  const auto place = [&](const DriveTable& drive) -> TableReader& {
    return holder(drive.key, document, mechanism);
  };
  std::vector<const DriveTable*> given;
  for (const DriveTable& drive : kDrives) {
    if (place(drive).has(drive.key)) given.push_back(&drive);
  }
  if (given.size() == 1) {
    TableReader table = place(*given.front()).table(given.front()->key);
    return given.front()->read(table, chain);
  }
  chain.names.incomplete = true;
  if (given.empty()) {
    holder(kCrank, document, mechanism)
        .fault(kCrank, fmt::format("is missing: {}; expected a [crank], a driving [slider] or a "
                                   "[cylinder]",
                                   mobility(dyads, 0)));
  } else {
    place(*given[1]).fault(given[1]->key,
                           fmt::format("is given beside {}: {}; expected one drive",
                                       place(*given[0]).name(given[0]->key), mobility(dyads, 2)));
  }
}

void place_waiting(std::vector<WaitingPoint>& waiting, Chain& chain) {
  auto placed = place_extra_points(waiting, chain.names);
  std::ranges::move(placed, std::back_inserter(chain.points));
}

// A pivot that nothing depends on is a slip of the pen: what was to turn about it is missing.
void check_pivots_used(std::vector<TableReader>& pivots, const Chain& chain,
                       const std::vector<WaitingPoint>& waiting) {
  for (TableReader& pivot : pivots) {
    const auto name = pivot.has_text("name") ? *pivot.text("name") : "";
    const auto mentions = [&](const WaitingPoint& point) {
      return std::ranges::find(point.description.on, name) != point.description.on.end();
    };
    const bool used = std::ranges::find(chain.used, name) != chain.used.end() ||
                      std::ranges::any_of(waiting, mentions);
    if (name.empty() || used) continue;
    pivot.fault("name",
                fmt::format("is {}, which nothing joins: the rest has {} without it; join it by a "
                            "[[dyad]] or remove it",
                            in_quotes(name), mobility(chain.mechanism.dyads.size(), 1)));
  }
}

}  // namespace

Chain read_chain(TableReader& document, TableReader& mechanism) {
  if (is_drawn(document, mechanism)) return read_drawn_chain(document, mechanism);
  Chain chain;
  const auto tables = [&](std::string_view key, std::size_t min, std::size_t max,
                          std::string_view of) {
    TableReader& place = holder(key, document, mechanism);
    return place.has(key) ? place.tables(key, {min, max, of}) : std::vector<TableReader>{};
  };
  auto pivots = tables("pivot", 1, kMostPivots, "pivots");
  auto dyads = tables("dyad", 1, kMostDyads, "dyads");
  for (TableReader& pivot : pivots) read_pivot(pivot, chain);
  const bool is_cylinder = holder(kCylinder, document, mechanism).contains(kCylinder);
  if (dyads.empty() && !is_cylinder && !document.has("dyad") && !mechanism.has("dyad")) {
    mechanism.fault("dyad", "is missing; a chain has one [[dyad]] or more");
  }
  announce_pins(document, mechanism, chain.names);
  for (TableReader& dyad : dyads) announce_name(dyad, "new", chain.names);
  auto waiting = read_extra_points(holder("point", document, mechanism), chain.names);
  for (TableReader& dyad : dyads) announce_joints(dyad, chain.names);
  const auto all_points = waiting;
  read_drive(document, mechanism, dyads.size(), chain);
  place_waiting(waiting, chain);
  for (TableReader& dyad : dyads) {
    read_dyad(dyad, chain);
    place_waiting(waiting, chain);
  }
  fault_unplaced(waiting, chain.names, document.faults());
  if (!chain.names.incomplete) check_pivots_used(pivots, chain, all_points);
  return chain;
}

}  // namespace cognate::problems::reading
