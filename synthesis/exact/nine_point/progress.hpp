/// @file Progress reported to a caller by many threads, one at a time.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>

namespace cognate::synthesis::nine_point {

class Progress {
 public:
  /// `tell` may be empty; it is called with shares of `total`, growing, each one step of a
  /// hundredth at least.
  Progress(const std::function<void(double)>& tell, int total) : tell_(tell), total_(total) {}

  void advance() {
    const int done = ++done_;
    if (!tell_) return;
    const std::unique_lock lock(telling_, std::try_to_lock);
    if (!lock || 100 * (done - told_) < total_ || done > total_) return;
    told_ = done;
    tell_(static_cast<double>(done) / total_);
  }

 private:
  const std::function<void(double)>& tell_;
  int total_, told_ = 0;
  std::atomic<int> done_{0};
  std::mutex telling_;
};

}  // namespace cognate::synthesis::nine_point
