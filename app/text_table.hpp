/// @file Rows of text set in aligned columns.
#pragma once

#include <string>
#include <vector>

namespace cognate::app {

/// A column's text is set flush left (words) or flush right (numbers).
enum class Align { left, right };

/// One column: its heading and, in the order of the rows, its cells.
struct Column {
  std::string heading;
  Align align = Align::left;
  std::vector<std::string> cells;
};

/// How many columns of a terminal `text` takes: its Unicode code points. Text is UTF-8.
std::size_t display_width(const std::string& text);

/// A heading line and one line for each row, two spaces between columns, no space at the end of a
/// line. All columns have the same number of cells. The lines carry no newline.
std::vector<std::string> set_columns(const std::vector<Column>& columns);

}  // namespace cognate::app
