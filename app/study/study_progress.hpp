/// @file How far a study has come, how fast, and how long it will take.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>

#include "app/progress.hpp"

namespace cognate::app {

/// "1 234 000 of 10 000 000 designs, 52 000/s, 2:49 left". `rate` is in designs per second; where
/// it is 0 it is left out with the time.
std::string progress_words(std::int64_t done, std::int64_t total, double rate);

/// `count` in groups of three digits.
std::string grouped(std::int64_t count);

/// Shows the progress of a run that goes on from `done` of `total` designs.
class StudyProgress {
 public:
  StudyProgress(bool quiet, std::int64_t done, std::int64_t total);

  void update(std::int64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  struct Mark {
    Clock::time_point time;
    std::int64_t done = 0;
  };

  Progress progress_;
  std::int64_t total_;
  std::deque<Mark> recent_;  ///< of the last seconds, from which the rate comes
};

}  // namespace cognate::app
