/// @file Rows of text set in aligned columns.
#pragma once

#include <string>
#include <vector>

#include "app/console/screen.hpp"

namespace cognate::app {

/// A column's text is set flush left (words) or flush right (numbers).
enum class Align { left, right };

/// One column: its heading and, in the order of the rows, its cells. What stands in brackets at a
/// heading's end is the unit of its cells, "rms [deg]": it is set below.
struct Column {
  std::string heading;
  Align align = Align::left;
  std::vector<std::string> cells;
};

/// A heading line, below it one of units where a column has one, and one line for each row, two
/// spaces between columns, no space at the end of a line. All columns have the same number of
/// cells. The lines carry no newline.
std::vector<std::string> set_columns(const std::vector<Column>& columns);

/// The same as text for `screen`, after an empty line and with headings in bold. Where it is not
/// wide enough for all columns they are set in blocks, one below the other, each with the first.
/// Lengths are called by the unit that the screen names.
std::string table_text(std::vector<Column> columns, const Screen& screen);

}  // namespace cognate::app
