#include "app/documents/list_section.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/console/text_table.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// A line for each entry, the meanings below one another.
std::string entries_text(std::span<const Entry> entries, std::string_view indent) {
  std::string text;
  std::size_t width = 0;
  for (const auto& entry : entries) width = std::max(width, entry.name.size());
  for (const auto& entry : entries) {
    text += fmt::format("{}{:<{}}  {}\n", indent, entry.name, width, entry.meaning);
  }
  return text;
}

ordered_json entries_json(std::span<const Entry> entries) {
  ordered_json rows = ordered_json::array();
  for (const auto& entry : entries) {
    ordered_json row = {{"name", entry.name}, {"meaning", entry.meaning}};
    if (!entry.type.empty()) row["type"] = entry.type;
    if (entry.values) row["values"] = entry.values();
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

ListSection list_section(std::string_view key, std::string_view heading,
                         std::span<const Entry> entries) {
  return {key, fmt::format("{}\n{}", heading, entries_text(entries, "  ")), entries_json(entries)};
}

ListSection list_section(std::string_view key, std::string_view heading,
                         std::span<const KeyedEntry> entries) {
  ListSection section{key, fmt::format("{}\n", heading), ordered_json::array()};
  for (const auto& entry : entries) {
    section.text += fmt::format("  {}: {}\n", entry.name, entry.meaning);
    section.text += entries_text(entry.keys, "      ");
    section.json.push_back(
        {{"name", entry.name}, {"meaning", entry.meaning}, {"keys", entries_json(entry.keys)}});
  }
  return section;
}

ListSection list_section(const MetricList& list) {
  Column keys{std::string(list.heading), Align::left, {}};
  Column units{"unit", Align::left, {}};
  Column meanings{"meaning", Align::left, {}};
  ListSection section{list.key, "", ordered_json::array()};
  Column symbols{"symbol", Align::left, {}};
  for (const auto& [key, unit, meaning, symbol] : list.metrics) {
    keys.cells.emplace_back(key);
    units.cells.emplace_back(unit);
    symbols.cells.emplace_back(symbol);
    meanings.cells.emplace_back(meaning);
    section.json.push_back({{"key", key}, {"unit", unit}, {"meaning", meaning}});
    if (!symbol.empty()) section.json.back()["symbol"] = symbol;
  }
  std::vector<Column> columns{keys, units, symbols, meanings};
  const auto has_symbol = [](const Metric& metric) { return !metric.symbol.empty(); };
  if (std::ranges::none_of(list.metrics, has_symbol)) columns.erase(columns.begin() + 2);
  for (const auto& line : set_columns(columns)) section.text += line + '\n';
  return section;
}

}  // namespace cognate::app
