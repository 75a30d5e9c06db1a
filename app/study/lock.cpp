#include "app/study/lock.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/console/messages.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

tl::unexpected<std::string> cannot_lock(const fs::path& file) {
  return tl::unexpected(fmt::format("cannot lock the study by '{}': {}", file.string(),
                                    std::generic_category().message(errno)));
}

/// "process 123 on name", as the holder wrote it.
std::string holder(int descriptor) {
  std::array<char, 256> text{};
  const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
  return size > 0 ? printable({text.data(), static_cast<std::size_t>(size)}) : "another process";
}

void write_holder(int descriptor) {
  std::array<char, 128> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::string text = fmt::format("process {} on {}", getpid(), host.data());
  // On a full disk the lock holds all the same.
  [[maybe_unused]] const int emptied = ::ftruncate(descriptor, 0);
  [[maybe_unused]] const ssize_t written = ::pwrite(descriptor, text.data(), text.size(), 0);
}

/// Whether `file` still is what is open as `descriptor`: whoever held it before may have removed
/// it.
bool is_there(const fs::path& file, int descriptor) {
  struct stat named {};
  struct stat opened {};
  return ::stat(file.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 &&
         named.st_ino == opened.st_ino && named.st_dev == opened.st_dev;
}

}  // namespace

fs::path final_target(const fs::path& file) {
  constexpr int kMostLinks = 40;  // as the system: beyond, they lead in a circle
  fs::path target = file;
  std::error_code error;
  for (int link = 0; link < kMostLinks && fs::is_symlink(target, error); ++link) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) break;
    target = target.parent_path() / next;  // `next` alone where it begins at the root
  }
  return target;
}

fs::path lock_file(const fs::path& database) {
  constexpr std::string_view kEnding = ".study.db";
  const std::string name = database.string();
  return (name.ends_with(kEnding) ? name.substr(0, name.size() - kEnding.size()) : name) +
         ".study.lock";
}

StudyLock::StudyLock(fs::path file, int descriptor)
    : file_(std::move(file)), descriptor_(descriptor) {}

StudyLock::StudyLock(StudyLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

StudyLock::~StudyLock() {
  if (descriptor_ == -1) return;
  if (is_there(file_, descriptor_)) ::unlink(file_.c_str());
  ::close(descriptor_);
}

tl::expected<StudyLock, std::string> StudyLock::take(const fs::path& file) {
  while (true) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor == -1) return cannot_lock(file);
    StudyLock lock(file, descriptor);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == -1) {
      lock.descriptor_ = -1;  // another one's: it is not to be removed
      const auto fault =
          errno == EWOULDBLOCK
              ? tl::unexpected(fmt::format("{} is running this study; it can be queried, but not "
                                           "run a second time before that one has ended",
                                           holder(descriptor)))
              : cannot_lock(file);
      ::close(descriptor);
      return fault;
    }
    if (is_there(file, descriptor)) {
      write_holder(descriptor);
      return lock;
    }
    lock.descriptor_ = -1;
    ::close(descriptor);
  }
}

}  // namespace cognate::app
