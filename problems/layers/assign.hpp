/// @file The layers of a mechanism's links.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/layers/plates.hpp"
#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/basics/quantity.hpp"
#include "problems/layers/layers.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {

/// The widths of all bodies, and pins and clearance, as the kernel takes them.
PlateSizes plate_sizes(const NamedMechanism& mechanism, const LayerSizes& sizes);

/// The fewest layers in which no link and no pin collides with another anywhere on `motion`, which
/// is one of `mechanism`, proven by exhaustion. The error says why nothing could be assigned: more
/// links than can be layered, or the time, once `stop` says that it is up.
tl::expected<LayerResult, std::string> assign_layers(const NamedMechanism& mechanism,
                                                     const AssemblyRanges& motion,
                                                     const LayerSizes& sizes,
                                                     const std::function<bool()>& stop = {});

/// The number of layers and how often pins cross one, where there are layers.
std::vector<Quantity> layer_quantities(const LayerResult& layers);

}  // namespace cognate::problems
