/// @file The text of a file that a user names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace cognate::problems::reading {

/// No file is read that is larger.
inline constexpr std::size_t kMostBytes = 8U << 20U;

/// Where a file is named: on the command line it may be a pipe or a terminal (standard input, the
/// output of another program), whose end is waited for; within another file it is a regular file,
/// because one that never ends would keep the program waiting for what nobody types.
enum class NamedBy { command_line, other_file };

/// What `file` holds, or why it cannot be read; what is requested.
tl::expected<std::string, std::string> text_of(const std::filesystem::path& file,
                                               NamedBy named_by = NamedBy::command_line);

}  // namespace cognate::problems::reading
