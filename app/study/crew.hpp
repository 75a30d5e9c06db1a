/// @file Those who evaluate the designs of a study: threads here, or processes elsewhere as well.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/study/bounded_queue.hpp"
#include "app/study/design_range.hpp"
#include "problems/study/block.hpp"

namespace cognate::app {

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
  /// Whether it was told to stop, or an evaluator has thrown.
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
