/// @file How fast a run comes on and how long it still takes, as the progress line reports it.
#include "app/console/progress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
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
  const RunPart unnamed, last{"certificate"}, first{"search", 0.5}, endless{"front", NAN};
  EXPECT_EQ(share_words(unnamed, 0.25, 0.0125, 3, "best 0.5"), "1:00 left, 1.2 %/s, best 0.5");
  EXPECT_EQ(share_words(last, 0.25, 0.0125, 3, ""), "certificate, 1:00 left, 1.2 %/s");
  EXPECT_EQ(share_words(first, 0.25, 0.0125, 3, ""), "search, 0:20 left of it, 1.2 %/s");
  EXPECT_EQ(share_words(first, 0.6, 0.0125, 3, ""), "search, 0:00 left of it, 1.2 %/s");
  EXPECT_EQ(share_words(endless, 0.25, 0.0125, 67, "best 2"), "front, 1:07 so far, best 2");
  EXPECT_EQ(share_words(last, 0.2, std::nullopt, 5, ""), "certificate, 0:05 so far");
  EXPECT_EQ(share_words(unnamed, 0, std::nullopt, 1, "best 0.5"), "best 0.5");
  EXPECT_EQ(share_words(unnamed, 0, std::nullopt, 1, ""), "");
}

TEST(RunProgress, KeepsWhatWasReachedAndKnowsItsPart) {
  RunProgress progress;
  progress.enter("search", 0.5);
  progress.update(0.2, 3);
  progress.update(0.1, std::numeric_limits<double>::infinity());
  EXPECT_EQ(progress.share(), 0.2);
  EXPECT_EQ(progress.best(), 3);
  const auto later = RunProgress::Clock::now() + 10s;
  // 0.2 in about ten seconds, and 0.3 to go.
  EXPECT_NEAR(progress.left(later).value(), 15, 0.2);
  EXPECT_NEAR(progress.seconds_in_part(later), 10, 0.2);
  EXPECT_EQ(progress.words(later).substr(0, 8), "search, ");
  EXPECT_NE(progress.words(later).find("left of it"), std::string::npos);
  progress.enter("front", NAN);
  EXPECT_FALSE(progress.left(later));
}

TEST(ProgressBar, FillsWithTheShare) {
  EXPECT_EQ(progress_bar(0.5, "0:10 left", 10), "[#####.....]  50 %  0:10 left");
  EXPECT_EQ(progress_bar(0, "", 4), "[....]   0 %");
  EXPECT_EQ(progress_bar(1.5, "", 4), "[####] 100 %");
  EXPECT_EQ(progress_bar(0.999, "", 4), "[####]  99 %");
}

}  // namespace
}  // namespace cognate::app::progress_test
