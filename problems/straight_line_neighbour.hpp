/// @file Stretches near another, from which a search looks beyond a local optimum.
#pragma once

#include <cstdint>
#include <optional>

#include "problems/straight_line_stretch.hpp"

namespace cognate::problems {

/// `stretch` with every dimension, its centre and its reach changed by up to `share` at random:
/// lengths by that share of themselves, the coupler point of the largest dimension, angles of the
/// reach. `stream` of `seed` says how. Empty where that does not close all along the stretch.
std::optional<LineStretch> neighbour(const LineStretch& stretch, double share, std::uint64_t seed,
                                     std::uint64_t stream);

}  // namespace cognate::problems
