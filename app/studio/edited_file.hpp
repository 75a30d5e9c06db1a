/// @file The file of a studio, which others may save as well.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "app/documents/file_watch.hpp"

namespace cognate::app {

/// A state of the file. The numbers count the texts that it has had, from 1.
struct FileVersion {
  std::uint64_t number = 0;
  std::string text{};
};

/// Why a text was not saved.
struct SaveFault {
  bool is_conflict = false;  ///< the file has changed since the version that was edited
  std::string message{};
};

/// A text of at most 512 KiB in UTF-8, on the disk. Where another program puts something else in
/// its place, the last version stays.
class EditedFile {
 public:
  /// What `file` holds; or why it cannot be edited. A link is followed, and stays one.
  static tl::expected<std::unique_ptr<EditedFile>, std::string> open(
      const std::filesystem::path& file);

  const std::filesystem::path& path() const { return path_; }

  FileVersion version() const;

  /// Reads the file again if it has been saved since; whether it then has another version. To be
  /// called in even steps of time.
  bool look();

  /// Puts `text` in the place of what the file holds, as a whole, unless that is no longer version
  /// `edited`; the new version.
  tl::expected<FileVersion, SaveFault> save(std::string_view text, std::uint64_t edited);

 private:
  EditedFile(std::filesystem::path path, std::string text);

  /// Makes `text` a new version if it is another one.
  bool take(tl::expected<std::string, std::string> text);

  const std::filesystem::path path_;
  FileWatch watch_;
  mutable std::mutex mutex_;
  FileVersion version_;
};

}  // namespace cognate::app
