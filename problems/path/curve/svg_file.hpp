/// @file SVG drawings.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>

namespace cognate::problems::reading {

/// The path data of the path in `file` whose id is `id`, or of its only path, in its own
/// coordinates. Paths that are not drawn where they stand (in `defs`, `symbol`, `clipPath`, `mask`,
/// `marker` or `pattern`) are found by their id alone. Else what is wrong and what is requested: no
/// regular file of at most 8 MiB, no XML, no such path, several without an `id`, or a `transform`,
/// which is not applied.
tl::expected<std::string, std::string> path_data_of(const std::filesystem::path& file,
                                                    const std::optional<std::string>& id);

}  // namespace cognate::problems::reading
