#include "app/studio/connections.hpp"

#include <system_error>
#include <thread>

namespace cognate::app {
namespace {

/// Far more than a browser opens, far fewer than a process has files.
constexpr int kMostConnections = 200;

}  // namespace

Connections::Taken Connections::enqueue(std::function<void()> serve) {
  {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return open_ < kMostConnections; });
    ++open_;
  }
  try {
    std::thread([this, serve] { run(serve); }).detach();
  } catch (const std::system_error&) {  // no more threads: this one then
    run(serve);
  }
  return static_cast<Taken>(true);
}

void Connections::run(const std::function<void()>& serve) {
  serve();
  const std::lock_guard lock(mutex_);
  --open_;
  ended_.notify_all();  // under the lock: once it is released, shutdown may destroy this
}

void Connections::shutdown() {
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [this] { return open_ == 0; });
}

}  // namespace cognate::app
