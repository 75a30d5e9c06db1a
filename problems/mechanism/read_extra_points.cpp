#include "problems/mechanism/read_extra_points.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::size_t kMostPoints = 1000;

std::vector<Mention> read_on(TableReader& table) {
  constexpr std::string_view kKey = "on";
  if (!table.has(kKey)) {
    table.fault(kKey, "is missing; expected the name of a body or two of its points");
    return {};
  }
  return read_mentions(table, kKey, {1, 2, "names"}).value_or(std::vector<Mention>{});
}

std::optional<WaitingPoint> read_extra_point(TableReader& table, PartNames& names) {
  constexpr std::string_view kName = "name";
  constexpr std::string_view kAt = "at";
  const std::size_t before = table.faults().size();
  WaitingPoint point;
  point.description.name = require_name(table, kName, "the point").value_or("");
  if (!point.description.name.empty()) {
    announce(names, {point.description.name, table.where(kName), table.name(kName)},
             table.faults());
  }
  point.on = read_on(table);
  if (!table.has(kAt)) table.fault(kAt, "is missing; expected [u, v] in the axes of its body");
  const Two at = table.two(kAt, kQuantity, "[u, v]").value_or(Two{});
  table.finish();
  if (table.faults().size() != before) return std::nullopt;
  point.description.at = {at[0], at[1]};
  for (const Mention& mention : point.on) point.description.on.push_back(mention.name);
  return point;
}

bool is_known(const PartNames& names, const Mention& mention) {
  return names.body(mention.name) || names.point(mention.name);
}

}  // namespace

std::vector<WaitingPoint> read_extra_points(TableReader& table, PartNames& names) {
  std::vector<WaitingPoint> points;
  for (TableReader& entry : table.tables("point", {0, kMostPoints, "points"})) {
    if (auto point = read_extra_point(entry, names)) {
      points.push_back(*std::move(point));
    } else {
      names.incomplete = true;
    }
  }
  return points;
}

std::vector<PointDescription> place_extra_points(std::vector<WaitingPoint>& waiting,
                                                 PartNames& names) {
  std::vector<PointDescription> placed;
  const auto place = [&](const WaitingPoint& point) {
    if (!std::ranges::all_of(point.on, [&](const Mention& on) { return is_known(names, on); })) {
      return false;
    }
    FaultList not_yet;
    const auto axes = find_axes(names, point.on, not_yet);
    if (!axes) return false;
    const Vec2d at = axes->origin + axes->direction * point.description.at;
    names.place(point.description.name, {axes->body, at});
    placed.push_back(point.description);
    return true;
  };
  // A point may lie on a line through another that stands after it in the file.
  while (std::erase_if(waiting, place) > 0) {
  }
  return placed;
}

void fault_unplaced(const std::vector<WaitingPoint>& waiting, const PartNames& names,
                    FaultList& faults) {
  for (const WaitingPoint& point : waiting) find_axes(names, point.on, faults);
}

}  // namespace cognate::problems::reading
