/// @file How fast a run comes on and how long it still takes, as the progress line reports it.
#include "app/console/progress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>

namespace cognate::app::progress_test {
namespace {

using namespace std::chrono_literals;

const auto kBegin = RateEstimate::Clock::time_point{} + 1h;

TEST(RateEstimate, IsThatOfTheLastSeconds) {
  RateEstimate rate_estimate(kBegin, 0);
  for (int i = 1; i <= 60; ++i)
    rate_estimate.mark(kBegin + i * 1s, i < 30 ? 2.0 * i : 58 + 5.0 * (i - 29));
  EXPECT_NEAR(rate_estimate.rate(kBegin + 60s).value(), 5, 1e-12);
}

TEST(RateEstimate, SinksWhileNothingHappens) {
  RateEstimate rate_estimate(kBegin, 0.25);
  EXPECT_FALSE(rate_estimate.rate(kBegin + 10s));  // nothing has been done
  rate_estimate.mark(kBegin + 100ms, 0.5);
  EXPECT_FALSE(rate_estimate.rate(kBegin + 100ms));  // nothing has been seen
  EXPECT_NEAR(rate_estimate.rate(kBegin + 1s).value(), 0.25, 1e-12);
  EXPECT_NEAR(rate_estimate.rate(kBegin + 5s).value(), 0.05, 1e-12);
}

TEST(RateEstimate, ForgetsNoPartOfManyMarks) {
  RateEstimate rate_estimate(kBegin, 0);
  for (int i = 1; i <= 100'000; ++i) rate_estimate.mark(kBegin + i * 100us, i);
  EXPECT_NEAR(rate_estimate.rate(kBegin + 10s).value(), 10'000, 1e-6);
}

TEST(ProgressWords, TellTimeLeftAndRate) {
  EXPECT_EQ(share_words(0.25, 0.0125, "best 0.5"), "1:00 left, 1.2 %/s, best 0.5");
  EXPECT_EQ(share_words(0.25, 0.0125, ""), "1:00 left, 1.2 %/s");
  EXPECT_EQ(share_words(0, std::nullopt, "best 0.5"), "best 0.5");
  EXPECT_EQ(share_words(0, std::nullopt, ""), "");
}

TEST(ProgressBar, FillsWithTheShare) {
  EXPECT_EQ(progress_bar(0.5, "0:10 left", 10), "[#####.....]  50 %  0:10 left");
  EXPECT_EQ(progress_bar(0, "", 4), "[....]   0 %");
  EXPECT_EQ(progress_bar(1.5, "", 4), "[####] 100 %");
  EXPECT_EQ(progress_bar(0.999, "", 4), "[####]  99 %");
}

}  // namespace
}  // namespace cognate::app::progress_test
