/// @file `[drive]`, `[[link]]`, `[[load]]` and `gravity` of a design problem.
#pragma once

#include "problems/operation.hpp"
#include "problems/reading/table_reader.hpp"

namespace cognate::problems::reading {

/// Which limits of the file ask for them.
struct OperationUse {
  bool by_acceleration = false;
  bool by_torque = false;
  bool has_coupler_point = true;
};

/// What nothing asks for is faulted; so are masses and loads where a limit of the torque has none.
Operation read_operation(TableReader& document, const OperationUse& use);

}  // namespace cognate::problems::reading
