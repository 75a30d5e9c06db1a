/// @file `[layers]` of a file.
#pragma once

#include <optional>

#include "problems/layers/layers.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// The table where the document has one.
std::optional<LayerSizes> read_layers(TableReader& document, const NamedMechanism& mechanism);

/// `layers`, of which that is read, where there are some.
Table layers_table(const std::optional<LayerSizes>& sizes);

}  // namespace cognate::problems::reading
