#include <atomic>
#include <chrono>
#include <stop_token>
#include <thread>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/commands/task_computation.hpp"
#include "app/console/interrupt.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/documents/file_watch.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kLook{80};

/// Stops a run once its file is saved again, or once the user interrupts it.
class RunStop {
 public:
  RunStop(FileWatch& watch, const std::atomic<bool>& interrupted)
      : thread_([&](const std::stop_token& ended) {
          while (!ended.stop_requested() && !raised_) {
            std::this_thread::sleep_for(kLook);
            if (watch.has_changed()) is_outdated_ = true;
            raised_ = is_outdated_ || interrupted;
          }
        }) {}

  const std::atomic<bool>& raised() const { return raised_; }
  bool is_outdated() const { return is_outdated_; }

  /// Looks no more; whether the file was saved until then.
  bool end() {
    thread_.request_stop();
    thread_.join();
    return is_outdated_;
  }

 private:
  std::atomic<bool> raised_{false}, is_outdated_{false};
  std::jthread thread_;  // last: it ends before what it writes to
};

/// A run of the file, and whether the file was saved meanwhile, which ends the run unreported.
struct WatchedRun {
  ExitStatus status;
  bool is_outdated;
};

WatchedRun run_once(Command command, const fs::path& file, const Options& options,
                    FileWatch& watch) {
  auto computation = file_computation(command, file, options);
  if (!computation) return {computation.error(), false};
  RunStop stop(watch, catch_interrupts());
  computation->run = [&stop, run = std::move(computation->run)](problems::Run options_of_run) {
    options_of_run.interrupted = &stop.raised();
    return run(options_of_run);
  };
  computation->is_abandoned = [&stop] { return stop.is_outdated(); };
  const ExitStatus status = compute(file, options, *computation);
  return {status, stop.end()};
}

/// False where the user ended the wait.
bool wait_for_save(FileWatch& watch) {
  while (!was_interrupted()) {
    if (watch.has_changed()) return true;
    std::this_thread::sleep_for(kLook);
  }
  return false;
}

}  // namespace

ExitStatus watch_command(Command command, const fs::path& file, const Options& options) {
  catch_interrupts();
  FileWatch watch(file);
  if (!file_stamp(file)) {
    const auto missing = file_computation(command, file, options);
    if (!missing) return missing.error();
  }
  while (true) {
    const auto [status, is_outdated] = run_once(command, file, options, watch);
    if (was_interrupted()) return status;
    if (is_outdated) continue;
    if (!options.quiet) {
      write_standard_error("cognate: watching " + printable(file.string()) + "; Ctrl-C ends\n");
    }
    if (!wait_for_save(watch)) return status;
  }
}

}  // namespace cognate::app
