#include "app/interrupt.hpp"

#include <csignal>

namespace cognate::app {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the flag is set by a signal handler");

extern "C" void on_signal(int) {
  interrupted.store(true, std::memory_order_relaxed);
}

void catch_once(int signal) {
  struct sigaction previous {};
  if (sigaction(signal, nullptr, &previous) == 0 && previous.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = on_signal;
  // The default action is back as soon as the handler has been entered: that is the second Ctrl-C.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(signal, &action, nullptr);
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  catch_once(SIGINT);
  catch_once(SIGTERM);
  return interrupted;
}

}  // namespace cognate::app
