#include "app/console/terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace cognate::app {
namespace {

bool is_capable_terminal(int descriptor) {
  const char* kind = std::getenv("TERM");
  return isatty(descriptor) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

/// One that does not know its width, as behind a serial line, has the usual one.
std::size_t terminal_width(int descriptor) {
  constexpr std::size_t kUsual = 80;
  constexpr std::size_t kLeast = 20;
  winsize size{};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) == -1 || size.ws_col == 0) return kUsual;
  return std::max<std::size_t>(size.ws_col, kLeast);
}

std::error_code write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return {errno, std::generic_category()};
    }
  }
  return {};
}

}  // namespace

Screen standard_output() {
  Screen screen;
  const char* refused = std::getenv("NO_COLOR");
  screen.colour = is_capable_terminal(STDOUT_FILENO) && (refused == nullptr || *refused == '\0');
  if (isatty(STDOUT_FILENO) == 1) screen.width = terminal_width(STDOUT_FILENO);
  return screen;
}

std::size_t error_width() {
  return terminal_width(STDERR_FILENO);
}

bool error_is_terminal() {
  return is_capable_terminal(STDERR_FILENO);
}

void hold_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free descriptor is the closed one. Opened for the wrong direction, so that using
    // it is the same error as before.
    const int mode = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (::open("/dev/null", mode) == -1) return;
  }
}

bool error_takes_text() {
  pollfd descriptor{STDERR_FILENO, POLLOUT, 0};
  return ::poll(&descriptor, 1, 0) != 0;
}

std::error_code write_standard_output(std::string_view text) {
  return write_all(STDOUT_FILENO, text);
}

void write_standard_error(std::string_view text) {
  // If even this cannot be written, there is nowhere to report it.
  [[maybe_unused]] const std::error_code unheard = write_all(STDERR_FILENO, text);
}

}  // namespace cognate::app
