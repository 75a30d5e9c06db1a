/// @file `[[link]]`, `[[load]]` and `gravity`: masses and loads of a mechanism.
#pragma once

#include <optional>
#include <vector>

#include "analysis/mechanism/forces.hpp"
#include "problems/mechanism/load_rule.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The tables `[[link]]` of `table`: mass properties of each body, in its own axes, zero where the
/// file says nothing.
std::vector<Inertia> read_links(TableReader& table, const PartNames& names);

/// The tables `[[load]]` of `table`.
std::vector<TableReader> load_tables(TableReader& table);

/// The load in one of them, `load`, whose other keys are left to the caller, as is `finish`. With
/// a driving slider (`slides`) an interval of the drive is one of lengths, else of degrees. Empty
/// where it is not known at what it acts.
std::optional<LoadRule> read_load(TableReader& load, const PartNames& names, bool slides);

/// All loads of `table`, which have no other keys.
std::vector<LoadRule> read_loads(TableReader& table, const PartNames& names, bool slides);

/// `gravity = [x, y]` of `table`, none where it is missing.
Vec2d read_gravity(TableReader& table);

}  // namespace cognate::problems::reading
