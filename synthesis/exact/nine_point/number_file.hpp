/// @file Files of numbers kept from one process to the next.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace cognate::synthesis::nine_point {

/// What the numbers of a file are: to be equal in who writes and who reads.
using FileKey = std::array<std::uint64_t, 3>;

/// The numbers of a file that write_numbers() has written with the same key; empty if there is none
/// that is whole, or if one of them is not finite. At most `most` are read.
std::optional<std::vector<double>> read_numbers(const std::filesystem::path& file,
                                                const FileKey& key, std::size_t most);

/// Writes a file that is there all at once or not at all. False if it could not be written.
bool write_numbers(const std::filesystem::path& file, const FileKey& key,
                   const std::vector<double>& numbers);

}  // namespace cognate::synthesis::nine_point
