/// @file What searches side by side do, in sum.
#pragma once

#include <mutex>

#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Counts what searches side by side do.
class SharedWork {
 public:
  explicit SharedWork(Work& sum) : sum_(sum) {}

  /// What `search(work)` finds, its work counted.
  template <class Search>
  auto counted(const Search& search) {
    Work own;
    auto found = search(own);
    const std::scoped_lock lock(guard_);
    sum_.candidates += own.candidates;
    sum_.positions += own.positions;
    sum_.gradients += own.gradients;
    sum_.solver_iterations += own.solver_iterations;
    return found;
  }

 private:
  Work& sum_;
  std::mutex guard_;
};

}  // namespace cognate::problems
