#include "app/console/text_table.hpp"

#include <algorithm>
#include <string_view>

#include "app/console/paint.hpp"
#include "problems/basics/length_unit.hpp"

namespace cognate::app {
namespace {

constexpr std::string_view kBetween = "  ";

/// Where the unit of `heading` begins, or its end.
std::size_t unit_begin(const std::string& heading) {
  const auto at = heading.ends_with(']') ? heading.rfind(" [") : std::string::npos;
  return std::min(at, heading.size());
}

std::string name_of(const Column& column) {
  return column.heading.substr(0, unit_begin(column.heading));
}

std::string unit_of(const Column& column) {
  const auto begin = unit_begin(column.heading);
  return begin < column.heading.size() ? column.heading.substr(begin + 1) : "";
}

bool have_units(const std::vector<Column>& columns) {
  return std::ranges::any_of(columns,
                             [](const Column& column) { return !unit_of(column).empty(); });
}

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string space(width - display_width(text), ' ');
  return align == Align::left ? text + space : space + text;
}

std::size_t width_of(const Column& column) {
  std::size_t width = std::max(display_width(name_of(column)), display_width(unit_of(column)));
  for (const auto& cell : column.cells) width = std::max(width, display_width(cell));
  return width;
}

/// Calls lengths by their unit, "[length/s²]" by "[mm/s²]".
void name_lengths(Column& column, const std::string& length) {
  const std::size_t unit = unit_begin(column.heading);
  column.heading.replace(unit, std::string::npos,
                         problems::in_length_unit(column.heading.substr(unit), length));
}

void append(std::string& line, const std::string& cell) {
  if (!line.empty()) line += kBetween;
  line += cell;
}

void trim_end(std::string& line) {
  line.erase(line.find_last_not_of(' ') + 1);
}

/// The columns in blocks of at most `width`, the first of all in front of each.
std::vector<std::vector<Column>> blocks(const std::vector<Column>& columns, std::size_t width) {
  const std::size_t key = width_of(columns.front());
  std::vector<std::vector<Column>> all{{columns.front()}};
  std::size_t used = key;
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const std::size_t wanted = kBetween.size() + width_of(columns[i]);
    const bool full = all.back().size() > 1 && used + wanted > width;
    if (full) {
      all.push_back({columns.front()});
      used = key;
    }
    all.back().push_back(columns[i]);
    used += wanted;
  }
  return all;
}

}  // namespace

std::vector<std::string> set_columns(const std::vector<Column>& columns) {
  const std::size_t rows = columns.empty() ? 0 : columns.front().cells.size();
  const std::size_t heads = have_units(columns) ? 2 : 1;
  std::vector<std::string> lines(heads + rows);
  for (const auto& column : columns) {
    const std::size_t width = width_of(column);
    append(lines[0], padded(name_of(column), width, column.align));
    if (heads == 2) append(lines[1], padded(unit_of(column), width, column.align));
    for (std::size_t row = 0; row < rows; ++row) {
      append(lines[heads + row], padded(column.cells[row], width, column.align));
    }
  }
  std::ranges::for_each(lines, trim_end);
  return lines;
}

std::string table_text(std::vector<Column> columns, const Screen& screen) {
  std::string text;
  for (Column& column : columns) name_lengths(column, screen.length);
  if (columns.empty()) return text;
  for (const auto& block : blocks(columns, screen.width)) {
    const std::size_t heads = have_units(block) ? 2 : 1;
    auto lines = set_columns(block);
    text += '\n';
    for (std::size_t i = 0; i < lines.size(); ++i) {
      text += (i < heads ? paint(lines[i], Colour::bold, screen.colour) : lines[i]) + '\n';
    }
  }
  return text;
}

}  // namespace cognate::app
