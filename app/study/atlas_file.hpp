/// @file A study file as an atlas of coupler curves.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/path/atlas_starts.hpp"
#include "problems/toml/fault.hpp"

namespace cognate::app {

/// The curves of the study file that `solve.atlas` of the problem names; none where it names none.
/// That the file is no atlas is a fault at the key.
tl::expected<std::vector<problems::AtlasCurve>, std::vector<problems::Fault>> problem_atlas(
    const problems::PathProblem& problem);

/// The four-bars of the study in `file` whose cranks turn fully, with the descriptors of their
/// curves; or what keeps it from being an atlas: no study file, no four-bars with varied dimensions
/// alone, no columns of descriptors, no curves.
tl::expected<std::vector<problems::AtlasCurve>, std::string> read_atlas(
    const std::filesystem::path& file);

}  // namespace cognate::app
