/// @file `[raster]` of quick returns.
#pragma once

#include "problems/quick_return/problem.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// Whether the file has a raster.
bool has_raster(const TableReader& document);

/// `[bounds]` of the lengths of a type other than a four-bar, which only a raster needs.
void read_return_bounds(TableReader& bounds, QuickReturnProblem& problem);
void write_return_bounds(TableWriter& document, const QuickReturnProblem& problem);

/// The raster of a file all else of which is read.
void read_return_raster(TableReader& document, QuickReturnProblem& problem);

}  // namespace cognate::problems::reading
