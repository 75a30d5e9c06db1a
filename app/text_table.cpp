#include "app/text_table.hpp"

#include <algorithm>

namespace cognate::app {
namespace {

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string space(width - display_width(text), ' ');
  return align == Align::left ? text + space : space + text;
}

std::size_t width_of(const Column& column) {
  std::size_t width = display_width(column.heading);
  for (const auto& cell : column.cells) width = std::max(width, display_width(cell));
  return width;
}

void append(std::string& line, const std::string& cell) {
  if (!line.empty()) line += "  ";
  line += cell;
}

void trim_end(std::string& line) {
  line.erase(line.find_last_not_of(' ') + 1);
}

}  // namespace

std::size_t display_width(const std::string& text) {
  const auto starts_code_point = [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; };
  return static_cast<std::size_t>(std::ranges::count_if(text, starts_code_point));
}

std::vector<std::string> set_columns(const std::vector<Column>& columns) {
  const std::size_t rows = columns.empty() ? 0 : columns.front().cells.size();
  std::vector<std::string> lines(rows + 1);
  for (const auto& column : columns) {
    const std::size_t width = width_of(column);
    append(lines[0], padded(column.heading, width, column.align));
    for (std::size_t row = 0; row < rows; ++row) {
      append(lines[row + 1], padded(column.cells[row], width, column.align));
    }
  }
  std::ranges::for_each(lines, trim_end);
  return lines;
}

}  // namespace cognate::app
