#include "analysis/numbers/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace cognate::parallel_test {
namespace {

TEST(ParallelFor, CallsEveryIndexOnceWhateverTheThreads) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> calls(1000);
    parallel_for(1000, threads, [&](int index, int) { ++calls[index]; });
    for (const auto& count : calls) ASSERT_EQ(count, 1) << threads << " threads";
  }
}

TEST(ParallelFor, NumbersThreadsBelowTheirCount) {
  std::vector<int> thread_of(64, -1);
  parallel_for(64, 3, [&](int index, int thread) { thread_of[index] = thread; });
  for (const int thread : thread_of) {
    EXPECT_GE(thread, 0);
    EXPECT_LT(thread, 3);
  }
}

TEST(ParallelFor, DoesNothingForNoWork) {
  parallel_for(0, 4, [](int, int) { FAIL(); });
}

TEST(ParallelFor, HandsAnExceptionToTheCaller) {
  const auto work = [] {
    parallel_for(100, 2, [](int index, int) {
      if (index == 5) throw std::runtime_error("five");
    });
  };
  EXPECT_THROW(work(), std::runtime_error);
}

}  // namespace
}  // namespace cognate::parallel_test
