/// @file How fast a run comes on, and how long it will still take.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace cognate::app {

/// The rate of something that grows, taken over the last seconds, so that it follows a run whose
/// parts take differently long. Times are those of a steady clock.
class RateEstimate {
 public:
  using Clock = std::chrono::steady_clock;

  /// The run begins, or goes on, from `done`.
  RateEstimate(Clock::time_point begun, double done) : marks_{{begun, done}} {}

  /// So much has been done at `now`.
  void mark(Clock::time_point now, double done);

  /// What is done in a second, seen from `now`: it sinks while nothing is marked. Nothing as long
  /// as too little has been seen.
  std::optional<double> rate(Clock::time_point now) const;

 private:
  struct Mark {
    Clock::time_point time;
    double done = 0;
  };

  std::deque<Mark> marks_;
};

/// Two figures of `rate`, since what follows them changes all the time: "0.35", "52 000".
std::string rounded_rate(double rate);

/// "2:49", "10 h 00 min", "3 days"; `seconds` are rounded up.
std::string duration(double seconds);

/// `count` in groups of three digits: "1 234 000".
std::string grouped(std::int64_t count);

}  // namespace cognate::app
