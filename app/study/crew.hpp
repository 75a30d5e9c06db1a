/// @file Those who evaluate the designs of a study: threads here, or processes elsewhere as well.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "app/study/design_range.hpp"
#include "problems/study/block.hpp"

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

/// The designs that are to be evaluated, handed out in blocks to any number of threads.
class WorkList {
 public:
  /// `block`: the greatest number of designs handed out at once.
  WorkList(std::vector<DesignRange> missing, std::int64_t block);

  /// The next block; empty at the end.
  std::optional<DesignRange> next();

 private:
  std::mutex guard_;
  std::vector<DesignRange> missing_;  ///< the next ones last
  std::int64_t block_;
};

/// A new evaluator for one thread, which gives up once `stopped` is set.
using EvaluatorMaker = std::function<problems::BlockEvaluator(const std::atomic<bool>* stopped)>;

/// Evaluates blocks until there are no more. Used from one thread.
class StudyCrew {
 public:
  StudyCrew() = default;
  StudyCrew(const StudyCrew&) = delete;
  StudyCrew& operator=(const StudyCrew&) = delete;
  virtual ~StudyCrew() = default;

  /// A block that has been evaluated; empty where none comes within `patience`.
  virtual std::optional<problems::StudyBlock> wait(std::chrono::milliseconds patience) = 0;
  /// Begins nothing more and gives up what is begun. Blocks that were done may still come.
  virtual void stop() = 0;
  /// Whether every block has come that will come. Throws what an evaluator threw.
  virtual bool is_finished() = 0;
  /// How many evaluate at once.
  virtual int size() const = 0;
};

/// Where a thread of a crew gets its next block; it may wait for it. Empty at the end.
using WorkSource = std::function<std::optional<DesignRange>()>;

/// A crew of threads of this process. Blocks wait in a queue of bounded length for whoever takes
/// them, so that memory does not depend on how many designs there are.
class ThreadCrew : public StudyCrew {
 public:
  /// `threads`: how many, or 0 for as many as the machine has.
  ThreadCrew(const EvaluatorMaker& maker, WorkSource source, int threads);
  ~ThreadCrew() override;

  std::optional<problems::StudyBlock> wait(std::chrono::milliseconds patience) override;
  void stop() override;
  bool is_finished() override;
  /// Whether it was stopped, or an evaluator has thrown.
  bool is_stopped() const { return stopped_; }
  int size() const override { return static_cast<int>(threads_.size()); }

 private:
  void work(const EvaluatorMaker& maker);

  std::atomic<bool> stopped_{false};
  std::atomic<int> working_{0};
  WorkSource source_;
  std::mutex failure_guard_;
  std::exception_ptr failure_;
  BoundedQueue<problems::StudyBlock> done_;
  std::vector<std::jthread> threads_;  ///< last, so that they end first
};

}  // namespace cognate::app
