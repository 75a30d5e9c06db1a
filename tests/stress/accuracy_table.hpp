/// @file Accuracies as rows of a Markdown table.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "tests/stress/accuracy.hpp"

namespace cognate::stress {

/// The heading; κ is the condition, ε = 2⁻⁵³.
inline std::string table_head(std::string_view second_column) {
  return fmt::format(
      "| configurations | {0} | worst error, ε | where κ ≤ {1} | where κ > {1}, over κ | wrong "
      "flags | furthest from the boundary, ε |\n|---|---|---|---|---|---|---|\n",
      second_column, kWell);
}

/// A number of the table; empty where there was nothing to measure.
inline std::string cell(double value) {
  return value == 0 ? "" : fmt::format("{:.{}g}", value, value < 1e4 ? 2 : 1);
}

inline std::string table_row(std::string_view family, std::string_view form, const Accuracy& a) {
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", family, form, cell(a.error),
                     cell(a.well_conditioned), cell(a.per_condition), a.wrong_flags,
                     a.wrong_flags == 0 ? "" : fmt::format("{:.2g}", a.wrong_flag_distance));
}

}  // namespace cognate::stress
