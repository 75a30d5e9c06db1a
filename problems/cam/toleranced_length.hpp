/// @file The tolerance of one length of a cam.
#pragma once

#include <optional>
#include <tl/expected.hpp>

#include "problems/cam/problem.hpp"
#include "problems/tolerance/dimensions.hpp"

namespace cognate::problems {

/// `dimension`, `nominal` long, with the tolerance that the file gives it; empty where it gives
/// none or 0, or why there cannot be one.
tl::expected<std::optional<TolerancedDimension>, ImpossibleTolerance> toleranced_length(
    const CamProblem& problem, CamDimension dimension, double nominal);

}  // namespace cognate::problems
