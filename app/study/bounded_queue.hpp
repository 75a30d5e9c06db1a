/// @file A queue between threads that never holds more than so many items.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace cognate::app {

template <class Item>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Waits for room; false, and the item is dropped, where the queue is closed.
  bool push(Item item) {
    std::unique_lock lock(guard_);
    room_.wait(lock, [&] { return closed_ || items_.size() < capacity_; });
    if (closed_) return false;
    items_.push_back(std::move(item));
    lock.unlock();
    filled_.notify_one();
    return true;
  }

  /// Waits for an item; empty where the queue is closed and empty, or `patience` is over.
  std::optional<Item> pop(std::chrono::milliseconds patience) {
    std::unique_lock lock(guard_);
    filled_.wait_for(lock, patience, [&] { return closed_ || !items_.empty(); });
    return take(lock);
  }

  /// As above, however long it takes.
  std::optional<Item> pop() {
    std::unique_lock lock(guard_);
    filled_.wait(lock, [&] { return closed_ || !items_.empty(); });
    return take(lock);
  }

  /// From now on nothing is taken in; what is there can still be taken out.
  void close() {
    {
      const std::scoped_lock lock(guard_);
      closed_ = true;
    }
    room_.notify_all();
    filled_.notify_all();
  }

  bool is_drained() const {
    const std::scoped_lock lock(guard_);
    return closed_ && items_.empty();
  }

 private:
  std::optional<Item> take(std::unique_lock<std::mutex>& lock) {
    if (items_.empty()) return std::nullopt;
    std::optional<Item> item(std::move(items_.front()));
    items_.pop_front();
    lock.unlock();
    room_.notify_one();
    return item;
  }

  mutable std::mutex guard_;
  std::condition_variable room_, filled_;
  std::deque<Item> items_;
  std::size_t capacity_;
  bool closed_ = false;
};

}  // namespace cognate::app
