/// @file How far a run has come, in which part it is, and how long that still takes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/console/rate_estimate.hpp"

namespace cognate::app {

/// The part that a run is in.
struct RunPart {
  std::string words;  ///< empty while none has a name
  double end = 1;     ///< share of the run; NaN where nobody knows when that comes
  RateEstimate::Clock::time_point begun = RateEstimate::Clock::now();
};

/// What a run reports of itself; of one thread at a time.
class RunProgress {
 public:
  using Clock = RateEstimate::Clock;

  /// A run that goes on from `share`.
  explicit RunProgress(double share = 0);

  /// `share` in [0, 1]; `best` may be infinite while nothing has been found. What has been reached
  /// is not taken back.
  void update(double share, double best);
  /// Another part of the run begins, `words`, which ends at the share `to`; NaN where the share
  /// done does not tell how long it takes.
  void enter(std::string_view words, double to);

  double share() const { return share_; }
  const RunPart& part() const { return part_; }
  /// Infinite while nothing has been found.
  double best() const { return best_; }
  /// Share done in a second, as RateEstimate has it.
  std::optional<double> rate(Clock::time_point now) const { return rate_estimate_.rate(now); }
  /// Seconds until the end of the part; nothing where nobody knows.
  std::optional<double> left(Clock::time_point now) const;
  double seconds_in_part(Clock::time_point now) const;

  /// As share_words has it.
  std::string words(Clock::time_point now) const;

 private:
  double share_;
  double best_;
  RunPart part_;
  RateEstimate rate_estimate_;
};

/// "certificate, 0:20 left, 3.1 %/s, best 0.0012" of a run of which `share` is done and `rate` in a
/// second; what is not known is left out: the rate where it is nothing, the best where it is empty.
/// "search, 0:05 left of it" in a part that is not the last; "front, 0:07 so far" where nothing is
/// known but that, `passed` seconds being the time in this part.
std::string share_words(const RunPart& part, double share, std::optional<double> rate,
                        double passed, std::string_view best);

}  // namespace cognate::app
