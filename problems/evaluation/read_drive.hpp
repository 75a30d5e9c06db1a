/// @file `[drive]`: how an analysis moves its mechanism.
#pragma once

#include "problems/evaluation/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The sweep in `table`; with a driving slider (`slides`) its ends are lengths, else angles.
/// `parts`: how many bodies and points each step evaluates, which limits the steps.
DriveSweep read_drive(TableReader& table, bool slides, std::size_t parts);

}  // namespace cognate::problems::reading
