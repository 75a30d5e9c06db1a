/// @file Whether a file has been saved since it was last looked at.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace cognate::app {

/// What changes of a file whenever it is saved, in place or by another that takes its name.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t size = 0;
  std::int64_t seconds = 0;  ///< of its last change
  std::int64_t nanoseconds = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// That of `file`, links followed; nothing where there is none.
std::optional<FileStamp> file_stamp(const std::filesystem::path& file);

/// Looks at a file again and again. A save is reported once, when the file has been the same at
/// two looks: not while it is being written, and not while an editor that puts a new file in its
/// place has taken it away.
class FileWatch {
 public:
  /// Of `file` as it stands now.
  explicit FileWatch(std::filesystem::path file);

  /// Whether it has been saved since this last said so. To be called in even steps of time.
  bool has_changed();

  /// Whether it still is as last reported: what was read since then is what that save wrote.
  bool is_as_reported() const;

 private:
  std::filesystem::path file_;
  std::optional<FileStamp> reported_, seen_;
};

}  // namespace cognate::app
