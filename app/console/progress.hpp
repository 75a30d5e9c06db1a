/// @file How far a run has come, on standard error.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "app/console/rate_estimate.hpp"

namespace cognate::app {

/// The part that a run is in.
struct RunPart {
  std::string words;  ///< empty while none has a name
  double end = 1;     ///< share of the run; NaN where nobody knows when that comes
  RateEstimate::Clock::time_point begun = RateEstimate::Clock::now();
};

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
  double share_ = 0;
  RunPart part_;
  std::string best_;
  RateEstimate rate_estimate_;
  std::thread writer_;  ///< none where nothing is shown
};

/// "[#####.....]  50 %  words": the bar has `width` cells.
std::string progress_bar(double share, std::string_view words, int width);

/// "certificate, 0:20 left, 3.1 %/s, best 0.0012" of a run of which `share` is done and `rate` in a
/// second; what is not known is left out: the rate where it is nothing, the best where it is empty.
/// "search, 0:05 left of it" in a part that is not the last; "front, 0:07 so far" where nothing is
/// known but that, `passed` seconds being the time in this part.
std::string share_words(const RunPart& part, double share, std::optional<double> rate,
                        double passed, std::string_view best);

/// "1 234 000 of 10 000 000 designs, 52 000/s, 2:49 left". `rate` is in designs per second; where
/// it is 0 it is left out with the time.
std::string progress_words(std::int64_t done, std::int64_t total, double rate);

}  // namespace cognate::app
