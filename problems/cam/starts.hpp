/// @file Where searches for cams begin.
#pragma once

#include <cstdint>
#include <vector>

#include "problems/cam/variables.hpp"

namespace cognate::problems {

/// `count` starts: the variables at proportions that cams usually have, then others drawn about
/// them, within the bounds. The same seed gives the same starts.
std::vector<std::vector<double>> cam_starts(const CamVariables& variables, int count,
                                            std::uint64_t seed);

}  // namespace cognate::problems
