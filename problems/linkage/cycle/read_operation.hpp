/// @file `[drive]`, `[flywheel]`, `[[link]]`, `[[load]]` and `gravity` of a design problem.
#pragma once

#include "problems/linkage/cycle/cycle_quantities.hpp"
#include "problems/linkage/cycle/operation.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Which parts of the file need them.
struct OperationUse {
  const CycleValues& asked;  ///< quantities that are limited or to be known
  bool has_coupler_point = true;
  bool has_strokes = true;  ///< whether the rocker must turn to and fro
};

/// What nothing needs is faulted; so are masses and loads where a limit of the torque has none.
Operation read_operation(TableReader& document, const OperationUse& use);

}  // namespace cognate::problems::reading
