#include "app/documents/output_files.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::generic_category().message(error);
}

tl::unexpected<std::string> cannot_write(const fs::path& file, int error) {
  return tl::unexpected(fmt::format("cannot write '{}': {}", file.string(), reason(error)));
}

/// The permissions of a new file, as the user's mask leaves them. Read once: the mask can only be
/// read by setting it.
mode_t new_file_mode() {
  static const mode_t mode = [] {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return static_cast<mode_t>(0666U & ~mask);
  }();
  return mode;
}

/// Has the system write what it keeps of a folder's entries; 0, or the errno. A file system that
/// cannot do that for folders has nothing to write.
int sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor == -1) return errno == EACCES ? 0 : errno;
  const int error = ::fsync(descriptor) == -1 ? errno : 0;
  ::close(descriptor);
  return error == EINVAL || error == ENOTSUP ? 0 : error;
}

/// A new file of its own in a folder, removed again unless it has been given its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& folder)
      : folder_(folder),
        path_((folder / ".cognate-XXXXXX").string()),
        descriptor_(::mkostemp(path_.data(), O_CLOEXEC)),
        open_error_(descriptor_ == -1 ? errno : 0) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ != -1) ::close(descriptor_);
    if (open_error_ == 0 && !renamed_) ::unlink(path_.c_str());
  }

  int open_error() const { return open_error_; }

  /// 0, or the errno of the first write that failed.
  int write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(descriptor_, text.data(), text.size());
      if (written == -1 && errno == EINTR) continue;
      if (written == -1) return errno;
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
  }

  /// Closes the file and gives it its name, in its folder; 0, or the errno of what failed. What it
  /// holds is on the disk before it has the name, and the name before this returns: whatever ends
  /// the machine, there is the old file or the new one.
  int rename_to(const fs::path& file) {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    const bool stored = ::fchmod(descriptor, new_file_mode()) == 0 && ::fsync(descriptor) == 0;
    const int error = stored ? 0 : errno;
    if (::close(descriptor) == -1) return errno;
    if (!stored) return error;
    if (::rename(path_.c_str(), file.c_str()) == -1) return errno;
    renamed_ = true;
    return sync_folder(folder_);
  }

 private:
  fs::path folder_;
  std::string path_;
  int descriptor_ = -1;
  int open_error_ = 0;
  bool renamed_ = false;
};

/// 0 where `file` is free or a file that may be replaced, else why not.
int obstacle(const fs::path& file) {
  struct stat found {};
  if (::lstat(file.c_str(), &found) == -1) return errno == ENOENT ? 0 : errno;
  return S_ISDIR(found.st_mode) ? EISDIR : 0;
}

}  // namespace

FileResult prepare_folder(const fs::path& folder, const std::vector<std::string>& names) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    return tl::unexpected(
        fmt::format("cannot make the folder '{}': {}", folder.string(), reason(error.value())));
  }
  if (const TemporaryFile probe(folder); probe.open_error() != 0) {
    return tl::unexpected(fmt::format("cannot write in the folder '{}': {}", folder.string(),
                                      reason(probe.open_error())));
  }
  for (const auto& name : names) {
    if (const int why = obstacle(folder / name); why != 0) return cannot_write(folder / name, why);
  }
  return {};
}

FileResult write_file(const fs::path& file, std::string_view text) {
  const auto folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  TemporaryFile temporary(folder);
  if (const int why = temporary.open_error(); why != 0) return cannot_write(file, why);
  if (const int why = temporary.write(text); why != 0) return cannot_write(file, why);
  if (const int why = temporary.rename_to(file); why != 0) return cannot_write(file, why);
  return {};
}

}  // namespace cognate::app
