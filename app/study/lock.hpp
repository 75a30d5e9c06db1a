/// @file Keeps two processes from running one study at the same time.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace cognate::app {

/// What `file` names in the end, through all symbolic links, whether or not it is there.
std::filesystem::path final_target(const std::filesystem::path& file);

/// The file of the lock of the study in `database`, which is no symbolic link: beside it, so that
/// a process that opens the database by another name finds the same lock.
std::filesystem::path lock_file(const std::filesystem::path& database);

/// A lock that ends with the process however that ends. It lies in a file of its own, so that
/// reading the database needs none.
class StudyLock {
 public:
  /// The lock of file `file`, which is made; or who holds it, or why there can be none.
  static tl::expected<StudyLock, std::string> take(const std::filesystem::path& file);

  StudyLock(StudyLock&& other) noexcept;
  StudyLock& operator=(StudyLock&&) = delete;
  /// Gives the lock back and removes its file.
  ~StudyLock();

 private:
  StudyLock(std::filesystem::path file, int descriptor);

  std::filesystem::path file_;
  int descriptor_;
};

}  // namespace cognate::app
