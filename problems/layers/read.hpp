/// @file `[layers]` of a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/layers/layers.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// The table where the document has one.
std::optional<LayerSizes> read_layers(TableReader& document, const NamedMechanism& mechanism);

/// The names of the links of a mechanism that is yet to be designed; of each that it may be.
using LinkNames = std::vector<std::vector<std::string>>;

/// The table and `layers_max` of `[constraints]`, where the document has the table. `refusal`: why
/// the problem takes no `layers_max`, empty where it does.
std::optional<DesignLayers> read_design_layers(TableReader& document, TableReader& constraints,
                                               const LinkNames& names,
                                               std::string_view refusal = {});

/// `layers_max`, where it is given.
void write_design_layers(const std::optional<DesignLayers>& layers, TableWriter& constraints);

/// `layers`, of which that is read, where there are some.
Table layers_table(const std::optional<LayerSizes>& sizes);
Table layers_table(const std::optional<DesignLayers>& layers);

}  // namespace cognate::problems::reading
