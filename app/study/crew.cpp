#include "app/study/crew.hpp"

#include <algorithm>
#include <ranges>
#include <system_error>
#include <utility>

#include "analysis/numbers/parallel.hpp"

namespace cognate::app {

WorkList::WorkList(std::vector<DesignRange> missing, std::int64_t block)
    : missing_(std::move(missing)), block_(block) {
  std::ranges::reverse(missing_);
}

std::optional<DesignRange> WorkList::next() {
  const std::scoped_lock lock(guard_);
  if (missing_.empty()) return std::nullopt;
  auto& rest = missing_.back();
  const DesignRange taken{rest.first, std::min(rest.count, block_)};
  rest.first += taken.count;
  rest.count -= taken.count;
  if (rest.count == 0) missing_.pop_back();
  return taken;
}

ThreadCrew::ThreadCrew(const EvaluatorMaker& maker, WorkSource source, int threads)
    : source_(std::move(source)), done_(2 * static_cast<std::size_t>(thread_count(threads))) {
  // Counted before they begin: the last one to end closes the queue.
  working_ = thread_count(threads);
  const int wanted = working_;
  for (int i = 0; i < wanted; ++i) {
    try {
      threads_.emplace_back([this, maker] { work(maker); });
    } catch (const std::system_error&) {
      if (threads_.empty()) throw;
      working_ -= wanted - i;  // the system has no more to give: those there are do the work
      if (working_ == 0) done_.close();
      break;
    }
  }
}

ThreadCrew::~ThreadCrew() {
  stopped_ = true;
  done_.close();
}

void ThreadCrew::work(const EvaluatorMaker& maker) {
  try {
    const auto evaluate = maker(&stopped_);
    while (!stopped_) {
      const auto range = source_();
      if (!range) break;
      auto block = evaluate(range->first, range->count);
      if (!block || !done_.push(std::move(*block))) break;
    }
  } catch (...) {
    stopped_ = true;
    const std::scoped_lock lock(failure_guard_);
    if (!failure_) failure_ = std::current_exception();
  }
  if (--working_ == 0) done_.close();
}

std::optional<problems::StudyBlock> ThreadCrew::wait(std::chrono::milliseconds patience) {
  return done_.pop(patience);
}

void ThreadCrew::stop() {
  stopped_ = true;
}

bool ThreadCrew::is_finished() {
  if (!done_.is_drained()) return false;
  const std::scoped_lock lock(failure_guard_);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return true;
}

}  // namespace cognate::app
