/// @file The threads of a server: one for each connection.
#pragma once

#include <httplib.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <utility>

namespace cognate::app {

/// A thread for each connection, so that none waits for another: connections that send nothing
/// hinder nobody. Up to a number of them; the next one waits to be accepted.
class Connections final : public httplib::TaskQueue {
 public:
  // void or bool, as the version of the library has it.
  using Taken = decltype(std::declval<httplib::TaskQueue&>().enqueue({}));

  Taken enqueue(std::function<void()> serve) override;
  /// Waits until the last connection has ended.
  void shutdown() override;

 private:
  void run(const std::function<void()>& serve);

  std::mutex mutex_;
  std::condition_variable ended_;
  int open_ = 0;
};

}  // namespace cognate::app
