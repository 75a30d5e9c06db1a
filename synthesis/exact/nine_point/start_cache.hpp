/// @file Start sets kept for the next problem: in memory, and in files if a folder is given.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "synthesis/exact/nine_point/start_set.hpp"

namespace cognate::synthesis::nine_point {

/// The start set of a class, found once in a process and, with a folder, once on a machine. Null
/// when stopped. A folder that cannot be written to and a file that is damaged are passed over.
std::shared_ptr<const StartSet> start_set(const PathClass& kind,
                                          const std::filesystem::path& folder,
                                          const TrackingOptions& means);

/// The file of a start set in its folder. Sets differ in their last digits from one instruction set
/// to another, so that each has its own.
std::filesystem::path start_file(const std::filesystem::path& folder, const PathClass& kind,
                                 const TrackingOptions& means);

/// Reads a file that write_start_set() has written; empty if there is none that is whole.
std::optional<StartSet> read_start_set(const std::filesystem::path& file, const PathClass& kind);

/// Writes a file that is there all at once or not at all. False if it could not be written.
bool write_start_set(const std::filesystem::path& file, const StartSet& set);

}  // namespace cognate::synthesis::nine_point
