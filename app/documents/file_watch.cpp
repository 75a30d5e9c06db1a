#include "app/documents/file_watch.hpp"

#include <sys/stat.h>

#include <utility>

namespace cognate::app {

std::optional<FileStamp> file_stamp(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) == -1) return std::nullopt;
  return FileStamp{.device = found.st_dev,
                   .inode = found.st_ino,
                   .size = found.st_size,
                   .seconds = found.st_mtim.tv_sec,
                   .nanoseconds = found.st_mtim.tv_nsec};
}

FileWatch::FileWatch(std::filesystem::path file)
    : file_(std::move(file)), reported_(file_stamp(file_)), seen_(reported_) {}

bool FileWatch::has_changed() {
  const auto now = file_stamp(file_);
  const bool settled = now == seen_;
  seen_ = now;
  if (!now || !settled || now == reported_) return false;
  reported_ = now;
  return true;
}

bool FileWatch::is_as_reported() const {
  return file_stamp(file_) == reported_;
}

}  // namespace cognate::app
