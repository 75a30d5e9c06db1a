/// @file `[drive]`, `[flywheel]`, `[[link]]`, `[[load]]` and `gravity` of a design problem.
#pragma once

#include "problems/linkage/operation.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Which limits of the file ask for them.
struct OperationUse {
  bool by_acceleration = false;
  bool by_ripple = false;
  bool by_fluctuation = false;
  bool by_flywheel = false;
  bool by_power = false;
  bool has_coupler_point = true;
  bool has_strokes = true;  ///< whether the rocker must turn to and fro

  bool by_energy() const { return by_fluctuation || by_flywheel; }
  /// Whether masses and loads matter.
  bool by_forces() const { return by_ripple || by_energy() || by_power; }
};

/// What nothing asks for is faulted; so are masses and loads where a limit of the torque has none.
Operation read_operation(TableReader& document, const OperationUse& use);

}  // namespace cognate::problems::reading
