#include "app/console/layers_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::app {
namespace {

using problems::LayerConflict;
using problems::LayerConflictKind;
using problems::LayerResult;

constexpr std::size_t kShownConflicts = 40;

const char* words_of(LayerConflictKind kind) {
  switch (kind) {
    case LayerConflictKind::joint:
      return "joined by a pin";
    case LayerConflictKind::slide:
      return "one slides on the other";
    case LayerConflictKind::collision:
      return "collide";
    case LayerConflictKind::unresolved:
      break;
  }
  return "too near to decide";
}

template <class T, class Text>
std::string listed(const std::vector<T>& all, const Text& text) {
  std::string list;
  for (const T& one : all) list += (list.empty() ? "" : ", ") + text(one);
  return list.empty() ? "–" : list;
}

std::string headline(const LayerResult& result) {
  if (!result.count) return "no number of layers suffices";
  return fmt::format(
      "{} layer{} above the frame: no fewer suffice, all were tried ({} ways to go on)",
      *result.count, *result.count == 1 ? "" : "s", result.tried);
}

std::string links_text(const LayerResult& result, const Screen& screen) {
  Column names{"link", Align::left, {}}, layers{"layer", Align::right, {}};
  Column widths{"width [length]", Align::right, {}};
  for (const auto& link : result.links) {
    names.cells.push_back(printable(link.name));
    layers.cells.push_back(link.layer > 0 ? fmt::format("{}", link.layer) : "–");
    widths.cells.push_back(fmt::format("{:.6g}", link.width));
  }
  return table_text({names, layers, widths}, screen);
}

std::string pins_text(const LayerResult& result, const Screen& screen) {
  Column names{"pin", Align::left, {}}, joins{"joins", Align::left, {}};
  Column crosses{"crosses layers", Align::left, {}};
  for (const auto& pin : result.pins) {
    names.cells.push_back(printable(pin.name));
    joins.cells.push_back(
        listed(pin.joins, [](const std::string& name) { return printable(name); }));
    crosses.cells.push_back(
        listed(pin.crosses, [](int layer) { return fmt::format("{}", layer); }));
  }
  return table_text({names, joins, crosses}, screen);
}

std::string part(const std::string& name, bool is_pin) {
  return (is_pin ? "pin " : "") + printable(name);
}

std::string conflicts_text(const LayerResult& result, bool drive_slides, const Screen& screen) {
  Column parts{"cannot share a layer", Align::left, {}}, why{"why", Align::left, {}};
  Column places{
      drive_slides ? "first at slide [length]" : "first at crank [deg]", Align::right, {}};
  const std::size_t shown = std::min(kShownConflicts, result.conflicts.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const LayerConflict& conflict = result.conflicts[i];
    parts.cells.push_back(part(conflict.first, conflict.first_is_pin) + " and " +
                          part(conflict.second, conflict.second_is_pin));
    why.cells.emplace_back(words_of(conflict.kind));
    const double place = conflict.drive.value_or(0);
    places.cells.push_back(
        conflict.drive
            ? fmt::format("{:.6g}", (drive_slides ? place : problems::degrees(place)) + 0.0)
            : "–");
  }
  if (shown == 0) return {};
  std::string text = table_text({parts, why, places}, screen);
  if (shown < result.conflicts.size()) {
    text += fmt::format("and {} more in the result file\n", result.conflicts.size() - shown);
  }
  return text;
}

}  // namespace

std::string layers_table(const LayerResult& result, bool drive_slides, const Screen& screen) {
  return '\n' + headline(result) + '\n' + links_text(result, screen) +
         (result.pins.empty() ? "" : pins_text(result, screen)) +
         conflicts_text(result, drive_slides, screen);
}

}  // namespace cognate::app
