/// @file Whether a cam has a best size at all.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Faults a problem in which nothing keeps the cam from shrinking to nothing or from growing
/// without end, or in which no length says how large anything is.
void check_cam_size(TableReader& mechanism, const CamProblem& problem);

}  // namespace cognate::problems::reading
