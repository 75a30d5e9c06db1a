/// @file When a computation has to end before it is done.
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>

namespace cognate::synthesis {

/// Stops a computation from outside: a cancellation or the end of its time.
class Deadline {
 public:
  /// `limit`: seconds from now, possibly infinite. `cancelled` may be null; else it must outlive
  /// this object.
  explicit Deadline(double limit = std::numeric_limits<double>::infinity(),
                    const std::atomic<bool>* cancelled = nullptr)
      : limit_(limit), cancelled_(cancelled) {}

  /// Whether it was cancelled, its time is over, or either.
  bool interrupted() const { return cancelled_ && cancelled_->load(); }
  bool expired() const { return std::isfinite(limit_) && remaining() <= 0; }
  bool reached() const { return interrupted() || expired(); }
  double remaining() const { return limit_ - spent(); }  ///< seconds, possibly infinite
  /// Seconds since construction.
  double spent() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  /// The cancellation, for solvers; may be null.
  const std::atomic<bool>* flag() const { return cancelled_; }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double limit_;
  const std::atomic<bool>* cancelled_;
};

}  // namespace cognate::synthesis
