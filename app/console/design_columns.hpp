/// @file The columns of the table of designs: what any of the designs has.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "app/console/text_table.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// A column for a quantity of the designs' metrics.
struct QuantityColumn {
  std::string_view quantity;  ///< as in `Metrics::quantities`
  std::string_view heading;
};

/// Of problems with several objectives.
inline constexpr QuantityColumn kObjectiveQuantities[] = {
    {"link_ratio", "link ratio"}, {"longest_link", "longest link [length]"}};

/// The columns of designs in addition to those of all kinds of problem.
struct ColumnChoice {
  std::string_view error_unit;  ///< errors are left out where empty, and in degrees where "deg"
  bool angular_output = false;  ///< whether speeds and accelerations are those of a rocker
  bool coupler_point = false;
  bool places =
      false;  ///< whether fixed pivots and the crank's angle at the first target are found
  std::span<const QuantityColumn> quantities;
};

/// A row for each of `designs`. Lengths have columns of their own where all designs are of one
/// type, else, and for chains, one column says the type and another its dimensions.
std::vector<Column> design_columns(std::span<const problems::Design> designs,
                                   const ColumnChoice& choice);

}  // namespace cognate::app
