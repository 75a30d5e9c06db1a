/// @file `kind = "path-generation"`.
#pragma once

#include <filesystem>

#include "problems/path/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The problem in `document`, complete if no fault was added. Drawings that it names are beside the
/// file, in `folder`; empty: there is none.
PathProblem read_path_problem(TableReader& document, const std::filesystem::path& folder);

}  // namespace cognate::problems::reading
