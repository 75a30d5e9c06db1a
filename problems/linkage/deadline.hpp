/// @file When a run has to end before it is done.
#pragma once

#include <atomic>
#include <chrono>

namespace cognate::problems {

struct Run;

/// Stops a run from outside: the user's interrupt or the end of its time.
class Deadline {
 public:
  explicit Deadline(const Run& run);

  bool interrupted() const;
  bool expired() const { return remaining() <= 0; }
  bool reached() const { return interrupted() || expired(); }
  double remaining() const;  ///< seconds, possibly infinite
  double spent() const;      ///< seconds since construction
  const std::atomic<bool>* flag() const { return interrupted_; }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double limit_;
  const std::atomic<bool>* interrupted_;
};

}  // namespace cognate::problems
