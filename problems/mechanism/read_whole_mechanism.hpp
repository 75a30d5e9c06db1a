/// @file `[mechanism]` with all dimensions, and of a chain the tables beside it.
#pragma once

#include <optional>

#include "problems/mechanism/named_mechanism.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// A mechanism, and the names of its parts for the tables that refer to them.
struct WholeMechanism {
  NamedMechanism mechanism;
  PartNames names;
  std::optional<double> drawn;  ///< of joints as drawn, what the drive is at there
};

/// The mechanism in the table `mechanism` of `document`; `mechanism.finish` is left to the caller.
/// Empty, with a fault, where it has no type.
std::optional<WholeMechanism> read_whole_mechanism(TableReader& document, TableReader& mechanism);

/// Names that say nothing, for what refers to a mechanism that could not be read; makes its tables
/// known.
PartNames unknown_parts(TableReader& document);

/// Whether a sliding body drives it, and no angle.
bool is_slider_driven(const NamedMechanism& mechanism);

}  // namespace cognate::problems::reading
