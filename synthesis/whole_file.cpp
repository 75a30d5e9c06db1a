#include "synthesis/whole_file.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace cognate {
namespace {

namespace fs = std::filesystem;

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

/// Signals by which a user ends a program wait, for this thread, until this is gone: at their
/// default they would leave the draft behind.
class HeldSignals {
 public:
  HeldSignals() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held, signal);
    pthread_sigmask(SIG_BLOCK, &held, &before_);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// A new file of its own in a folder, removed again unless it has been given its final name.
class Draft {
 public:
  enum class Signals { held, as_they_are };
  explicit Draft(const fs::path& folder, Signals signals = Signals::held)
      : folder_(folder),
        path_((folder / ".cognate-XXXXXX").string()),
        descriptor_(::mkostemp(path_.data(), O_CLOEXEC)),
        open_error_(descriptor_ == -1 ? errno : 0) {
    if (signals == Signals::as_they_are) held_.reset();
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft() {
    if (descriptor_ != -1) ::close(descriptor_);
    if (open_error_ == 0 && !renamed_) ::unlink(path_.c_str());
  }

  int open_error() const { return open_error_; }
  const std::string& path() const { return path_; }

  /// 0, or the errno of the first write that failed.
  int write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written == -1 && errno == EINTR) continue;
      if (written == -1) return errno;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
  }

  /// Closes the file and gives it its name, in its folder; 0, or the errno of what failed.
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
  // First: until the file has its name or is removed.
  std::optional<HeldSignals> held_{std::in_place};
  fs::path folder_;
  std::string path_;
  int descriptor_ = -1;
  int open_error_ = 0;
  bool renamed_ = false;
};

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

}  // namespace

int write_whole_file(const fs::path& file, const std::function<int(const fs::path&)>& fill) {
  Draft draft(folder_of(file), Draft::Signals::as_they_are);
  if (draft.open_error() != 0) return draft.open_error();
  if (const int error = fill(draft.path()); error != 0) return error;
  return draft.rename_to(file);
}

int write_whole_file(const fs::path& file, std::string_view bytes) {
  Draft draft(folder_of(file));
  if (draft.open_error() != 0) return draft.open_error();
  if (const int error = draft.write(bytes); error != 0) return error;
  return draft.rename_to(file);
}

int try_to_write_in(const fs::path& folder) {
  return Draft(folder).open_error();
}

}  // namespace cognate
