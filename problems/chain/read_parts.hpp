/// @file The tables of a chain whose dimensions are found where they are not given: `[crank]`,
/// `[[pivot]]`, `[[dyad]]`, `[[point]]` and `[bounds]`.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "problems/chain/topology.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// How files write that a dimension is found, as where its key is missing.
inline constexpr const char* kFreeDimension = "free";

/// The tables of the parts, wherever in the file they stand.
struct PartTables {
  std::vector<TableReader> pivots, cranks, dyads, points;

  PartTables(TableReader& document, TableReader& mechanism);

  /// All of them, each with what a table makes.
  std::vector<std::pair<synthesis::LineType, std::vector<TableReader>*>> all();
};

/// Whether a `[[dyad]]` has the type of a link with three pins.
bool is_three_pin_link(TableReader& dyad);

/// Why what is given of a link with three pins is refused.
inline constexpr std::string_view kThreePinsAreFound =
    "is given of a three-pin link, whose dimensions are found; remove it: [bounds] limits them";

/// The dimensions that the file gives of a chain, whose tables have been read but for these: what
/// lies outside its bounds is a fault.
void read_given(PartTables& parts, std::vector<Topology>& topologies);

/// The same of known topologies, by the names of their points.
void read_given_by_name(PartTables& parts, std::vector<Topology>& topologies);

/// `[bounds]`: `length`, `pivots` and `point` for all, and by the name of a point for it alone.
void read_chain_bounds(TableReader& bounds, std::vector<Topology>& topologies);

}  // namespace cognate::problems::reading
