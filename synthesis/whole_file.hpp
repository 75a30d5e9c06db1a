/// @file Files that are there all at once or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace cognate {

/// Gives `file` the contents `bytes`, in place of what it held: whichever way the process ends or
/// the machine, there is the old file or the new one. The bytes are on the disk before they have
/// the file's name, and the name before this returns; a draft in the same folder is removed where
/// something fails. Gives 0, or the errno of what failed.
int write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// The same of a file whose contents `fill` writes to the draft that it is given, which is there
/// and empty; `fill` gives 0, or the errno of what failed. Signals are as the caller has them.
int write_whole_file(const std::filesystem::path& file,
                     const std::function<int(const std::filesystem::path& draft)>& fill);

/// 0 if a file can be made in `folder`, which is left as it was, else the errno.
int try_to_write_in(const std::filesystem::path& folder);

}  // namespace cognate
