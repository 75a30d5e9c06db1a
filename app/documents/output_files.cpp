#include "app/documents/output_files.hpp"

#include <fmt/core.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "synthesis/whole_file.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::generic_category().message(error);
}

tl::unexpected<std::string> cannot_write(const fs::path& file, int error) {
  return tl::unexpected(fmt::format("cannot write '{}': {}", file.string(), reason(error)));
}

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
  if (const int why = try_to_write_in(folder); why != 0) {
    return tl::unexpected(
        fmt::format("cannot write in the folder '{}': {}", folder.string(), reason(why)));
  }
  for (const auto& name : names) {
    if (const int why = obstacle(folder / name); why != 0) return cannot_write(folder / name, why);
  }
  return {};
}

FileResult write_file(const fs::path& file, std::string_view text) {
  if (const int why = write_whole_file(file, text); why != 0) return cannot_write(file, why);
  return {};
}

}  // namespace cognate::app
