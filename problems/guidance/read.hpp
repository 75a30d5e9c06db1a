/// @file Reading `kind = "motion-generation"`.
#pragma once

#include "problems/guidance/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The problem of a document of this kind; what is wrong with it is added to the document's faults.
MotionProblem read_motion_problem(TableReader& document);

}  // namespace cognate::problems::reading
