/// @file Whether the parts of a chain have names of their own.
#pragma once

#include "problems/chain/topology.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Names of links are made of those of their points; two parts of one name are a fault.
void check_names(const Topology& topology, TableReader& mechanism);

}  // namespace cognate::problems::reading
