/// @file Work shared out over threads so that the result does not depend on their number.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace cognate {

/// The number of threads to use when `asked` for: as many as the machine has for 0, at least one.
inline int thread_count(int asked) {
  if (asked > 0) return asked;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Calls `body(index, thread)` once for each index in [0, count), from `threads` threads numbered
/// from 0, the caller being number 0. Indices are handed out in order, one at a time; the calls
/// overlap, so `body` must write its result to a place of its own index, to be reduced in order of
/// the index afterwards. The first exception of a body ends the work and is thrown to the caller.
template <class Body>
void parallel_for(int count, int threads, Body&& body) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex failure_guard;
  const auto work = [&](int thread) {
    try {
      for (int index = next++; index < count; index = next++) body(index, thread);
    } catch (...) {
      next = count;
      const std::scoped_lock lock(failure_guard);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int thread = 1; thread < std::min(thread_count(threads), count); ++thread) {
      try {
        helpers.emplace_back(work, thread);
      } catch (const std::system_error&) {
        break;  // the system has no thread to give: those there are do the work
      }
    }
    work(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace cognate
