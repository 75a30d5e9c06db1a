/// @file `solve.objectives` and the bounds on the error that go with them.
#pragma once

#include <optional>
#include <string_view>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// What of a problem decides which objectives it can have.
struct ObjectiveScope {
  ErrorMeasure error;           ///< what its error is
  std::string_view exact{};     ///< why it has no error to be bounded; empty where it has one
  std::string_view refusal{};   ///< why it has no other measures; empty where it has
  bool has_sizes = true;        ///< whether lengths are lengths, not ratios to one of them
  bool needs_full_turn = true;  ///< whether the transmission angle is searched over full turns only
};

/// `rms_error_max`, `rms_error_deg_max` or `max_error_deg_max`, whichever is the error of the
/// problem; the others are faults.
std::optional<ErrorLimit> read_error_limit(TableReader& constraints, ErrorMeasure measure);

/// The number of designs of a front: at least 2, by default 12.
void read_front_designs(TableReader& solve_table, Solve& solve);

/// That limit of `[constraints]`, and `solve.objectives`; with a front, `solve.designs` is 12 by
/// default. The rest of both tables has been read.
void read_objectives(TableReader& constraints_table, TableReader& solve_table,
                     const ObjectiveScope& scope, Constraints& constraints, Solve& solve);

}  // namespace cognate::problems::reading
