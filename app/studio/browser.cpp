#include "app/studio/browser.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

namespace cognate::app {
namespace {

#ifdef __APPLE__
constexpr const char* kOpener = "open";
bool has_desktop() {
  return true;
}
#else
constexpr const char* kOpener = "xdg-open";
/// Without one a browser for terminals would be started, in this one.
bool has_desktop() {
  return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
}
#endif

}  // namespace

void open_in_browser(const std::string& address) {
  if (!has_desktop()) return;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, descriptor, "/dev/null", O_RDWR, 0);
  }
  // In a group of its own, which the terminal's Ctrl-C passes by.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  std::string opener = kOpener, argument = address;
  const std::array<char*, 3> words = {opener.data(), argument.data(), nullptr};
  pid_t child = 0;
  ::posix_spawnp(&child, kOpener, &files, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
}

}  // namespace cognate::app
