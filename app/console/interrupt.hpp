/// @file Ctrl-C ends a run in good order; a second one ends it at once.
#pragma once

#include <atomic>

namespace cognate::app {

/// Whether a line on the terminal is to be wiped before the second Ctrl-C ends the program.
std::atomic<bool>& unfinished_line();

/// From now on SIGINT, SIGTERM and SIGHUP set the flag that is returned, and nothing else; the
/// second one ends the program as if it had never been caught. A signal that the caller ignores
/// stays ignored.
const std::atomic<bool>& catch_interrupts();

/// Whether a caught signal has come.
bool was_interrupted();

/// From now on the signals end the program again.
void release_interrupts();

}  // namespace cognate::app
