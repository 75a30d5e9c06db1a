/// @file Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace cognate::app {

/// What went wrong, as a message that names the file or folder.
using FileResult = tl::expected<void, std::string>;

/// Makes `folder` with the folders above it where they are missing, and finds out whether files
/// can be made in it and whether each of `names` may become one (is not a folder, is not too long).
/// Run before a long computation whose result is to be written there.
FileResult prepare_folder(const std::filesystem::path& folder,
                          const std::vector<std::string>& names);

/// Replaces `file` by one that holds `text`. Whoever reads it sees the old file or the new one,
/// never a part: the text goes to a temporary file beside it, which then takes its name.
FileResult write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace cognate::app
