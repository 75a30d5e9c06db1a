/// @file Which body of a chain is its output.
#pragma once

#include <array>
#include <string>

#include "problems/chain/topology.hpp"

namespace cognate::problems {

/// The body of `topology` that carries both points called `output`, which one does; of a guide and
/// its slider the slider, which is the last.
int output_body(const Topology& topology, const std::array<std::string, 2>& output);

}  // namespace cognate::problems
