/// @file The columns of the table of designs: what any of the designs has.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "app/console/text_table.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// A column for a fact of the designs' metrics.
struct FactColumn {
  std::string_view fact;  ///< as in `Metrics::facts`
  std::string_view heading;
};

/// What is told of designs besides what all kinds of problem have.
struct ColumnChoice {
  std::string_view error_unit;  ///< errors are left out where empty, and in degrees where "deg"
  std::string_view acceleration_unit = "length/s²";  ///< of the output
  bool coupler_point = false;
  std::span<const FactColumn> facts;
};

/// A row for each of `designs`. Lengths have columns of their own where all designs are of one
/// type, else, and for chains, one column says the type and another its dimensions.
std::vector<Column> design_columns(std::span<const problems::Design> designs,
                                   const ColumnChoice& choice);

}  // namespace cognate::app
