/// @file How far a run has come, on standard error.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "app/console/run_progress.hpp"

namespace cognate::app {

/// Shows how far a run has come, how fast it comes on and how long it will still take: on a
/// terminal as a bar that overwrites itself, elsewhere as a line every few seconds. A run that ends
/// quickly shows nothing. A thread of its own writes, so that the line lives while the run is busy;
/// where the terminal takes no text, the line waits and the run goes on.
class Progress {
 public:
  /// A run of which only the share done is known. `quiet`: show nothing at all. `stopping` is
  /// raised when the run has to end.
  Progress(bool quiet, const std::atomic<bool>& stopping);
  /// A run that goes on from `done` of `total` designs.
  Progress(bool quiet, const std::atomic<bool>& stopping, std::int64_t done, std::int64_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Wipes the bar off the terminal.
  ~Progress();

  /// `share` in [0, 1]; `best`, the best objective so far, may be infinite while nothing has been
  /// found. May be called from any thread; what has been reached is not taken back.
  void update(double share, double best);
  /// Another part of the run begins, `words`, which ends at the share `to`; NaN where the share
  /// done does not tell how long it takes.
  void enter(std::string_view words, double to);
  /// So many designs of the total have been done.
  void update(std::int64_t done);

 private:
  Progress(bool quiet, const std::atomic<bool>& stopping, double share, std::int64_t total);
  void write_until_done();
  void show(const std::string& text);
  std::string line() const;
  std::string words() const;

  const std::atomic<bool>& stopping_;
  const bool terminal_;
  const std::int64_t total_;  ///< designs; 0 where they are not counted
  bool bar_shown_ = false;    ///< known to the writer alone

  std::mutex mutex_;
  std::condition_variable done_;
  bool is_done_ = false;
  RunProgress run_;
  std::thread writer_;  ///< none where nothing is shown
};

/// "[#####.....]  50 %  words": the bar has `width` cells.
std::string progress_bar(double share, std::string_view words, int width);

/// "1 234 000 of 10 000 000 designs, 52 000/s, 2:49 left". `rate` is in designs per second; where
/// it is 0 it is left out with the time.
std::string progress_words(std::int64_t done, std::int64_t total, double rate);

}  // namespace cognate::app
