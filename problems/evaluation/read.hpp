/// @file `kind = "analysis"`.
#pragma once

#include "problems/evaluation/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The problem in `document`, complete if no fault was added.
AnalysisProblem read_analysis_problem(TableReader& document);

}  // namespace cognate::problems::reading
