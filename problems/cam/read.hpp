/// @file `kind = "cam"`.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads every table; what is wrong is faulted, and the problem is then of no use.
CamProblem read_cam_problem(TableReader& document);

}  // namespace cognate::problems::reading
