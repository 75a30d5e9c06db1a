/// @file Times of pieces of code on a machine with other work: all are run in turn, again and
/// again, and the least time of each counts.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cognate::bench {

/// Something to measure, which treats `items` items at each call.
struct Case {
  std::string name;
  double items = 1;
  std::function<void()> run;
  double nanoseconds = INFINITY;  ///< for one item; the least seen
};

inline double seconds_of(const Case& one, int calls) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) one.run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Measures every case in `rounds` rounds, a case taking about `slice` seconds in each.
inline void measure(std::vector<Case>& cases, int rounds, double slice = 4e-4) {
  std::vector<int> calls;
  for (const Case& one : cases) {
    one.run();
    const double least = std::min(seconds_of(one, 1), seconds_of(one, 1));
    calls.push_back(std::max(1, static_cast<int>(slice / std::max(least, 1e-9))));
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const double each = seconds_of(cases[i], calls[i]) / (calls[i] * cases[i].items);
      cases[i].nanoseconds = std::min(cases[i].nanoseconds, 1e9 * each);
    }
  }
}

}  // namespace cognate::bench
