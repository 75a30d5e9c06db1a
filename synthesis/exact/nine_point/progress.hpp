/// @file Progress reported to a caller by many threads, one at a time.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>

namespace cognate::synthesis::nine_point {

class Progress {
 public:
  /// `report` may be empty; it is called with shares of `total`, growing, each one step of a
  /// hundredth at least.
  Progress(const std::function<void(double)>& report, int total) : report_(report), total_(total) {}

  void advance() {
    const int done = ++done_;
    if (!report_) return;
    const std::unique_lock lock(reporting_, std::try_to_lock);
    if (!lock || 100 * (done - reported_) < total_ || done > total_) return;
    reported_ = done;
    report_(static_cast<double>(done) / total_);
  }

 private:
  const std::function<void(double)>& report_;
  int total_, reported_ = 0;
  std::atomic<int> done_{0};
  std::mutex reporting_;
};

}  // namespace cognate::synthesis::nine_point
