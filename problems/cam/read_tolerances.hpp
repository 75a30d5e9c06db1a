/// @file What a cam's `[tolerance]` must not be.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Faults a tolerance that a length which the file gives cannot have.
void check_cam_tolerances(TableReader& document, const CamProblem& problem);

}  // namespace cognate::problems::reading
