/// @file What the error of a chain is weighed against.
#pragma once

#include "problems/basics/names.hpp"

namespace cognate::problems {

/// The least transmission angle of its joints, its longest link, or the number of its links.
enum class ChainMeasure { transmission_angle, size, links };

template <>
std::span<const Named<ChainMeasure>> names<ChainMeasure>();

}  // namespace cognate::problems
