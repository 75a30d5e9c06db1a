/// @file The one computation of a studio: begun, watched and stopped from pages.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <tl/expected.hpp>
#include <vector>

#include "app/commands/computation.hpp"
#include "app/console/options.hpp"
#include "app/console/run_progress.hpp"

namespace cognate::app {

/// How a run stands. Runs are counted from 1; of run 0 nothing has begun.
struct RunState {
  enum class Phase { idle, solving, done, failed };

  std::uint64_t run = 0;
  Phase phase = Phase::idle;
  RunProgress progress{};
  double seconds = 0;
  std::string status{};      ///< of the result, once done
  std::string message{};     ///< why it failed
  std::uint64_t report = 0;  ///< the run whose result and page there are; 0: none
  std::size_t designs = 0;   ///< of that result
};

/// Computes what texts ask for, one at a time: a new request ends the run before it, of which
/// nothing is kept. A stop ends a run too, and what it has found is its result.
class Workbench {
 public:
  explicit Workbench(Options options);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;
  /// Stops what runs.
  ~Workbench();

  /// Begins with `text`, whose files are looked for in `folder`; the number of the run, or every
  /// fault in the text, which leaves what runs alone.
  tl::expected<std::uint64_t, std::vector<problems::Fault>> solve(
      const std::string& text, const std::filesystem::path& folder);

  void stop();

  RunState state() const;

  /// The page of the last run that has one; empty where none has.
  std::shared_ptr<const std::string> report() const;

  /// The document of that run; null where there is none.
  std::shared_ptr<const nlohmann::ordered_json> result() const;

  /// Calls `changed` after every change of the state, from any thread.
  void on_change(std::function<void()> changed) { changed_ = std::move(changed); }

 private:
  using Clock = std::chrono::steady_clock;
  struct Job;

  void work();
  void run(const std::shared_ptr<Job>& job);
  /// Changes the state by `change`, unless `job` is no longer the one that is asked for.
  template <class Change>
  void update(const Job& job, Change change);

  const Options options_;
  std::function<void()> changed_ = [] {};

  mutable std::mutex mutex_;
  std::condition_variable asked_;
  RunState state_;
  Clock::time_point begun_;
  std::shared_ptr<const std::string> report_;
  std::shared_ptr<const nlohmann::ordered_json> result_;
  std::shared_ptr<Job> job_;  ///< the newest, running or waiting for the one before to end
  bool is_taken_ = true;      ///< whether that runs already
  bool closing_ = false;
  std::thread worker_;  // last: it works on the others
};

}  // namespace cognate::app
