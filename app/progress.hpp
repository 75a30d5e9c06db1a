/// @file How far a run has come, on standard error.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace cognate::app {

/// Shows the share done and the best objective so far (an error, a size) or other words: on a
/// terminal as a bar that overwrites itself, elsewhere as a line every few seconds. A run that ends
/// quickly shows nothing. Used from one thread at a time.
class Progress {
 public:
  /// `quiet`: show nothing at all.
  explicit Progress(bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Wipes the bar off the terminal.
  ~Progress();

  /// `share` in [0, 1]; `best` may be infinite while nothing has been found.
  void update(double share, double best);
  /// The same with `words` in the place of the best.
  void update(double share, std::string_view words);

 private:
  using Clock = std::chrono::steady_clock;

  bool quiet_ = false;
  bool terminal_ = false;
  bool bar_shown_ = false;
  Clock::time_point next_;
};

/// "[#####.....]  50 %  best 1.2e-3": the bar has `width` cells; a `best` that is not finite
/// is left out.
std::string progress_bar(double share, double best, int width);
/// The same with `words` in the place of the best.
std::string progress_bar(double share, std::string_view words, int width);

}  // namespace cognate::app
