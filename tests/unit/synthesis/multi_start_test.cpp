/// The engine behind all searches, over candidates that are numbers.
#include "synthesis/search/multi_start.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

namespace cognate::synthesis::testing::multi_start_test {
namespace {

struct Number {
  double value = 0;
  int hits = 1;
  int absorbed = 0;
};

/// Least first; negative ones violate a limit.
struct NumberRules {
  using Candidate = Number;

  static bool has_value(const Number& one) { return !std::isnan(one.value); }
  static bool precedes(const Number& a, const Number& b) { return a.value < b.value; }
  static bool is_same(const Number& known, const Number& other, double tolerance) {
    return std::abs(known.value - other.value) <= tolerance;
  }
  static double value(const Number& one) {
    return one.value < 0 ? std::numeric_limits<double>::infinity() : one.value;
  }
  static void absorb(Number& known, const Number& same) { known.absorbed += 1 + same.absorbed; }
};

std::vector<Number> numbers(std::initializer_list<double> values) {
  std::vector<Number> all;
  for (const double value : values) all.push_back({value});
  return all;
}

TEST(MultiStart, MergesWhatIsTheSameIntoTheBest) {
  auto all = numbers({3, 1.01, NAN, 1, 7, 1.02});
  sort_and_merge(NumberRules{}, all, 0.015);
  ASSERT_EQ(all.size(), 4U);  // 1.02 is the same as 1.01, which is gone, but not as 1
  EXPECT_EQ(all[0].value, 1);
  EXPECT_EQ(all[0].hits, 2);
  EXPECT_EQ(all[0].absorbed, 1);
  EXPECT_EQ(all[1].value, 1.02);
  EXPECT_EQ(all[3].value, 7);
}

TEST(MultiStart, DrawsRoundsUntilTheBestIsKnown) {
  const Deadline never;
  MultiStart<NumberRules> search({}, {1, never});
  std::vector<int> rounds;
  const StartRule rule{.round = 10, .fewest = 20, .most = 100, .enough_hits = 3, .patience = 2};
  // One start in twenty leads to 1, and from the 25th on one in ten to 0.5.
  search.explore(rule, {}, [&](int first, int count) {
    rounds.push_back(first);
    std::vector<Number> fresh;
    for (int i = first; i < first + count; ++i) {
      const bool best = i >= 25 && i % 10 == 5;
      fresh.push_back({best ? 0.5 : i % 20 == 0 ? 1 : 2 + i});
    }
    search.add(std::move(fresh), 0);
  });
  // 0.5 is found in the round of 20 to 29, and for the third time in that of 40 to 49; the starts
  // drawn must be twice 30.
  EXPECT_EQ(rounds, (std::vector<int>{0, 10, 20, 30, 40, 50}));
  EXPECT_EQ(search.starts(), 60);
  EXPECT_EQ(search.all().front().hits, 4);
}

TEST(MultiStart, DrawsAsManyAsAreAskedFor) {
  const Deadline never;
  MultiStart<NumberRules> search({}, {1, never});
  int drawn = 0;
  search.explore({.starts = 25, .round = 10}, {}, [&](int first, int count) {
    EXPECT_EQ(first, drawn);
    drawn += count;
    search.add(std::vector<Number>(static_cast<std::size_t>(count), {1.0}), 0);
  });
  EXPECT_EQ(drawn, 25);
  EXPECT_EQ(search.all().front().hits, 25);
}

TEST(MultiStart, CountsMinimaWithinLimitsThatWereSeenOnce) {
  const Deadline never;
  MultiStart<NumberRules> search({}, {1, never});
  search.add(numbers({-1, 1, 1, 2, 3}), 0);
  const SearchStatistics statistics = search.statistics();
  EXPECT_EQ(statistics.best_hits, 1);
  EXPECT_DOUBLE_EQ(statistics.unseen, 3.0 / 5);  // 2, 3 and one start more
}

TEST(MultiStart, AsksOfTheBestHowWellTheBestIsKnown) {
  const Deadline never;
  MultiStart<NumberRules> search({}, {1, never});
  // However many starts lead to the worst, of those that lead to the best two half saw theirs once.
  search.add(numbers({1, 1, 1, 2, 9, 9, 9, 9, 9, 9}), 0);
  EXPECT_DOUBLE_EQ(search.statistics(2).unseen, 2.0 / 5);
  EXPECT_DOUBLE_EQ(search.statistics().unseen, 2.0 / 11);
}

/// Values within a tenth of the best of their group are one minimum.
struct NearNumberRules : NumberRules {
  static bool is_near(const Number& best, const Number& other) {
    return other.value <= 1.1 * best.value;
  }
};

TEST(MultiStart, CountsMinimaNearOneAnotherAsOne) {
  const Deadline never;
  MultiStart<NearNumberRules> search({}, {1, never});
  search.add(numbers({1, 1.05, 1.09, 1.15, 2, 2.1}), 0);
  EXPECT_DOUBLE_EQ(search.statistics().unseen, 2.0 / 7);  // 1.15 and one start more
}

TEST(MultiStart, GoesOnInDoubt) {
  const Deadline never;
  MultiStart<NumberRules> search({}, {1, never});
  // The best in every other start, in the first rounds others that are seen once.
  search.explore({.round = 10, .fewest = 10, .enough_hits = 2, .doubt = 0.2}, {},
                 [&](int first, int count) {
                   std::vector<Number> fresh;
                   for (int i = first; i < first + count; ++i) {
                     fresh.push_back({i % 2 == 0 || i >= 10 ? 1.0 : 2.0 + i});
                   }
                   search.add(std::move(fresh), 0);
                 });
  EXPECT_EQ(search.starts(), 30);  // 6 of 11, 6 of 21, 6 of 31
}

TEST(MultiStart, KeepsTheBest) {
  const Deadline never;
  MultiStart<NumberRules> search({}, {1, never});
  search.add(numbers({5, 4, 3, 2, 1}), 0);
  search.keep(2);
  ASSERT_EQ(search.all().size(), 2U);
  EXPECT_EQ(search.all().back().value, 2);
  search.keep(7);
  EXPECT_EQ(search.all().size(), 2U);
}

TEST(MultiStart, DoesNothingOnceTheDeadlineIsReached) {
  std::atomic<bool> cancelled{false};
  const Deadline deadline(1e9, &cancelled);
  MultiStart<NumberRules> search({}, {3, deadline});
  search.add(numbers({1, 2, 3}), 0);
  cancelled = true;
  int calls = 0;
  search.refine({}, [&](Number&) { ++calls; });
  search.explore({}, {}, [&](int, int) { ++calls; });
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(search.starts(), 0);
  EXPECT_EQ(search.all().size(), 3U);
}

}  // namespace
}  // namespace cognate::synthesis::testing::multi_start_test
