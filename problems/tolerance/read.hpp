/// @file `[tolerance]` of a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/tolerance/tolerances.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// What of a mechanism `[tolerance]` may name.
struct ToleranceScope {
  std::vector<std::string> dimensions;  ///< besides length and pivots
  std::vector<std::string> joints;      ///< those that may have clearance
  std::vector<std::string> points;      ///< that an analysis may judge; of other kinds none
  bool has_pivots = true;
  bool has_error = true;             ///< whether there is an error that a yield can be of
  std::string_view unit = "length";  ///< of that error: "length" or "deg"
};

/// The dimensions and joints of mechanisms that are yet to be designed.
ToleranceScope four_bar_scope();
ToleranceScope slider_crank_scope();
ToleranceScope guide_bar_scope();

/// The table where the document has one; it says something, or that is a fault.
std::optional<Tolerances> read_tolerances(TableReader& document, const ToleranceScope& scope);

/// `tolerance`, of which that is read, where there are some; `angle`: whether the error judged is
/// one.
Table tolerance_table(const std::optional<Tolerances>& tolerances, bool angle);

/// Faults a tolerance that cannot be, at the key that gives it: that of the dimension `group`, else
/// the one that is for all.
void fault_impossible(TableReader& document, std::string_view group, std::string_view reason);

}  // namespace cognate::problems::reading
