/// @file The curves of the atlas that a problem names.
#pragma once

#include <tl/expected.hpp>
#include <vector>

#include "problems/path/atlas_starts.hpp"
#include "problems/toml/fault.hpp"

namespace cognate::app {

/// The curves of the study file that `solve.atlas` of the problem names; none where it names none.
/// That the file is no atlas is a fault at the key.
tl::expected<std::vector<problems::AtlasCurve>, std::vector<problems::Fault>> problem_atlas(
    const problems::PathProblem& problem);

}  // namespace cognate::app
