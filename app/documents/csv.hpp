/// @file The table of an analysis as CSV (RFC 4180).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "problems/evaluation/result.hpp"

namespace cognate::app {

/// A word as a cell: quoted where it holds a comma, a quote or a line break.
std::string csv_cell(std::string_view text);

/// A column of words that stands before all others; none where its name is empty.
struct CsvWords {
  std::string name{};
  std::vector<std::string> cells{};  ///< one for each row
};

/// A header line with the columns' names, then one line for each row; lines end in CR LF. A name
/// that holds a comma, a quote or a line break is quoted. Numbers are the shortest that read back
/// to the same double, with a decimal point in any locale; what is not a number is an empty
/// cell.
///
/// `length`, the unit of lengths where it is known, stands in the names of columns that hold
/// lengths: "C_x_mm", "C_vx_mm_per_s".
std::string csv_text(std::span<const problems::Column> columns, const CsvWords& words = {},
                     std::string_view length = {});

}  // namespace cognate::app
