/// @file `[constraints]` and `[target]` of a cam.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads `problem.constraints`; what they need of the rest of `problem` must have been read.
void read_cam_constraints(TableReader& constraints, CamProblem& problem);

/// `target.objective`, in the same way.
void read_cam_objective(TableReader& target, CamProblem& problem);

}  // namespace cognate::problems::reading
