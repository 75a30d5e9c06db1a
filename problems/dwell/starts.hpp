/// @file Chains drawn at random whose output nearly dwells.
#pragma once

#include <optional>
#include <random>

#include "problems/dwell/model.hpp"

namespace cognate::problems {

/// The best of many chains drawn. Where the output's dyad joins a moving point E and a pivot G of
/// the frame that may be anywhere, the output stands still while E moves along a circle about the
/// joint F: the circle nearest to E over a window gives F and the length EF; G is drawn. Else the
/// output is evaluated as drawn.
std::optional<DwellDesign> draw_dwell(const DwellSpace& space, std::mt19937_64& random);

}  // namespace cognate::problems
