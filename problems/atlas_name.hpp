/// @file The atlas that a problem file names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace cognate::problems {

/// `solve.atlas` of a problem file that has been found sound, as written: a study file beside it.
/// What begins a search is no part of the problem, so the problem does not hold it. Empty where the
/// file names none.
std::optional<std::string> atlas_name(const std::filesystem::path& file);

}  // namespace cognate::problems
