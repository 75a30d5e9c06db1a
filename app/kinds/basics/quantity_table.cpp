#include "app/kinds/basics/quantity_table.hpp"

#include <algorithm>

#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "app/study/metrics.hpp"
#include "problems/basics/length_unit.hpp"

namespace cognate::app {

namespace {

/// Of forces it says what it holds for, where the unit of lengths is not known.
std::string unit_of(const std::string& metric, const Screen& screen) {
  const std::string unit = metric_unit(metric);
  const bool is_force = unit == "N" || unit == "N m";
  if (is_force && screen.length.empty()) return unit + " for lengths in m";
  return problems::in_length_unit(unit, screen.length);
}

/// The symbol in `listed` of a metric, which may be that of a part, "pinion.teeth".
std::string symbol_of(std::string_view name, std::span<const Metric> listed) {
  name = name.substr(name.rfind('.') + 1);
  for (const Metric& metric : listed) {
    const auto keys = single_keys(metric.key), symbols = single_keys(metric.symbol);
    const auto place = std::ranges::find(keys, name) - keys.begin();
    if (place < std::ssize(symbols)) return symbols[static_cast<std::size_t>(place)];
  }
  return "";
}

}  // namespace

std::string quantity_table(std::span<const problems::Quantity> quantities, const Screen& screen,
                           std::span<const Metric> with_symbols) {
  if (quantities.empty()) return {};
  Column names{"metric", Align::left, {}};
  Column symbols{"symbol", Align::left, {}};
  Column values{"value", Align::left, {}};
  Column units{"unit", Align::left, {}};
  for (const auto& quantity : quantities) {
    names.cells.push_back(printable(quantity.name));
    symbols.cells.push_back(symbol_of(quantity.name, with_symbols));
    values.cells.push_back(std::visit(WrittenValue{}, quantity.value));
    units.cells.push_back(unit_of(quantity.name, screen));
  }
  if (with_symbols.empty()) return table_text({names, values, units}, screen);
  return table_text({names, symbols, values, units}, screen);
}

}  // namespace cognate::app
