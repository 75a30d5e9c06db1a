/// @file `[[link]]`, `[[load]]` and `gravity`: what a mechanism weighs and bears.
#pragma once

#include <vector>

#include "problems/analysis/analysis_problem.hpp"
#include "problems/reading/part_names.hpp"
#include "problems/reading/table_reader.hpp"

namespace cognate::problems::reading {

/// The tables `[[link]]` of `table`: mass properties of each body, in its own axes, zero where the
/// file says nothing.
std::vector<Inertia> read_links(TableReader& table, const PartNames& names);

/// The tables `[[load]]` of `table`. With a driving slider (`slides`) an interval of the drive is
/// one of lengths, else of degrees.
std::vector<LoadRule> read_loads(TableReader& table, const PartNames& names, bool slides);

/// `gravity = [x, y]` of `table`, none where it is missing.
Vec2d read_gravity(TableReader& table);

}  // namespace cognate::problems::reading
