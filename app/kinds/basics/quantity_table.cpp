#include "app/kinds/basics/quantity_table.hpp"

#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "app/study/metrics.hpp"

namespace cognate::app {

std::string quantity_table(std::span<const problems::Quantity> quantities, const Screen& screen) {
  if (quantities.empty()) return {};
  Column names{"metric", Align::left, {}};
  Column values{"value", Align::left, {}};
  Column units{"unit", Align::left, {}};
  for (const auto& quantity : quantities) {
    names.cells.push_back(printable(quantity.name));
    values.cells.push_back(std::visit(WrittenValue{}, quantity.value));
    units.cells.push_back(metric_unit(quantity.name));
  }
  return table_text({names, values, units}, screen);
}

}  // namespace cognate::app
