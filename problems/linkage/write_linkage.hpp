/// @file `[mechanism]`, `[bounds]`, `[constraints]` and `[solve]` of linkages, written down.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/basics/length_unit.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// `kind`, `title` and `length_unit`, to which the tables of the file are added.
TableWriter document_writer(std::string_view kind, const std::string& title,
                            std::optional<LengthUnit> length_unit);

/// `type`: that of the mechanism.
TableWriter given_writer(const Given& given, std::string_view type = "four-bar");
TableWriter bounds_writer(const Bounds& bounds);
TableWriter constraints_writer(const Constraints& constraints);
TableWriter solve_writer(const Solve& solve);

/// `drive`, `flywheel`, `link`, `load` and `gravity`, where limits or objectives depend on them. A
/// fault is what no file can leave out: the member of `constraints` that an objective is measured
/// by.
Table operation_tables(const Constraints& constraints, const Solve& solve,
                       std::vector<std::string>& faults);

}  // namespace cognate::problems::reading
