#include "app/console/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <string_view>

namespace cognate::app {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the flag is set by a signal handler");

std::atomic<bool> line_is_unfinished{false};

constexpr int kCaught[] = {SIGINT, SIGTERM, SIGHUP};

/// The first signal only raises the flag, the second ends the program as if it had not been caught,
/// on an empty line.
extern "C" void on_signal(int signal) {
  if (!interrupted.exchange(true)) return;
  if (line_is_unfinished.load()) {
    constexpr std::string_view kWipe = "\r\x1b[K";
    [[maybe_unused]] const auto unheard = ::write(STDERR_FILENO, kWipe.data(), kWipe.size());
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void catch_once(int signal) {
  struct sigaction previous {};
  if (sigaction(signal, nullptr, &previous) == 0 && previous.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

std::atomic<bool>& unfinished_line() {
  return line_is_unfinished;
}

const std::atomic<bool>& catch_interrupts() {
  for (const int signal : kCaught) catch_once(signal);
  return interrupted;
}

bool was_interrupted() {
  return interrupted.load();
}

void release_interrupts() {
  for (const int signal : kCaught) {
    struct sigaction present {};
    const bool known = sigaction(signal, nullptr, &present) == 0;
    if (known && present.sa_handler == on_signal) std::signal(signal, SIG_DFL);
  }
}

}  // namespace cognate::app
