/// @file The text of a file that a user names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace cognate::problems::reading {

/// No file is read that is larger.
inline constexpr std::size_t kMostBytes = 8U << 20U;

/// What `file` holds, or why it cannot be read; what is wanted.
tl::expected<std::string, std::string> text_of(const std::filesystem::path& file);

}  // namespace cognate::problems::reading
