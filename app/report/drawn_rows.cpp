#include "app/report/drawn_rows.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::app {
namespace {

/// The rows in which `values` is least and greatest, its gaps left out.
void add_extremes(const std::vector<double>& values, std::vector<std::size_t>& rows) {
  std::size_t least = values.size(), greatest = values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    if (least == values.size() || values[i] < values[least]) least = i;
    if (greatest == values.size() || values[i] > values[greatest]) greatest = i;
  }
  if (least < values.size()) rows.insert(rows.end(), {least, greatest});
}

std::vector<std::size_t> even_rows(std::size_t count, std::size_t of) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < count; ++i) {
    rows.push_back((2 * i * (of - 1) + count - 1) / (2 * (count - 1)));
  }
  return rows;
}

}  // namespace

std::vector<std::size_t> drawn_rows(std::span<const problems::Column> columns, std::size_t most,
                                    std::size_t cells) {
  const std::size_t count = columns.empty() ? 0 : columns.front().values.size();
  if (count == 0) return {};
  const std::size_t room = std::clamp<std::size_t>(cells / columns.size(), 3, most);
  auto rows =
      even_rows(std::max<std::size_t>(2, std::min(count, room)), std::max<std::size_t>(2, count));
  if (count < 2) return {0};
  // Two rows for each column would be more than the even ones where there are very many columns.
  if (room < count && columns.size() < room / 2) {
    for (const problems::Column& column : columns) add_extremes(column.values, rows);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

}  // namespace cognate::app
