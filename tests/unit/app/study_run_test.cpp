/// @file Running a study: all rows with any number of threads, in memory that does not grow,
/// stopped and gone on with.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/console/progress.hpp"
#include "app/study/block_message.hpp"
#include "app/study/run.hpp"
#include "tests/support/study_samples.hpp"

namespace cognate::app::study_run_test {
namespace {

using namespace std::chrono_literals;
using tests::sample_block;
using tests::sample_study;
using tests::TestFolder;

const StudyOrigin kOrigin{.text = "base = 'base.toml'\n", .version = "1.2.3"};

EvaluatorMaker sample_evaluators() {
  return [](const std::atomic<bool>*) {
    return [](std::int64_t first, std::int64_t count) {
      return std::optional(sample_block(first, count));
    };
  };
}

struct Ran {
  StudyEnd end;
  StudyCounts counts;
};

Ran run_once(const std::filesystem::path& file, const problems::Study& study,
             const EvaluatorMaker& maker, int threads, const std::atomic<bool>& interrupted,
             std::optional<double> time_limit = {}) {
  StudyDatabase database(file, study, kOrigin);
  WorkList work(database.missing(), 64);
  ThreadCrew crew(
      maker, [&] { return work.next(); }, threads);
  const auto end = run_study(
      database, crew, {.interrupted = interrupted, .time_limit = time_limit, .progress = [] {}});
  return {end, database.counts()};
}

std::string all_rows(const std::filesystem::path& file) {
  SqliteDatabase database(file, SqliteDatabase::Access::read);
  return database.text(
      "SELECT group_concat(id || quote(\"a.first\") || quote(second) || class || status) "
      "FROM (SELECT * FROM runs ORDER BY id)");
}

TEST(StudyRun, HasTheSameRowsWithAnyNumberOfThreads) {
  const TestFolder folder;
  const auto study = sample_study(5000);
  const std::atomic<bool> interrupted{false};
  const auto one = run_once(folder / "one.db", study, sample_evaluators(), 1, interrupted);
  const auto five = run_once(folder / "five.db", study, sample_evaluators(), 5, interrupted);
  EXPECT_EQ(one.end, StudyEnd::done);
  EXPECT_EQ(five.counts.evaluated, 5000);
  EXPECT_EQ(five.counts.kept, 5000 - 715);
  EXPECT_EQ(all_rows(folder / "one.db"), all_rows(folder / "five.db"));
}

TEST(StudyRun, GoesOnWhereItWasInterrupted) {
  const TestFolder folder;
  const auto study = sample_study(5000);
  std::atomic<bool> interrupted{false};
  std::atomic<int> blocks{0};
  const EvaluatorMaker interrupting = [&](const std::atomic<bool>* stopped) {
    return [&, stopped](std::int64_t first, std::int64_t count) {
      if (++blocks == 20) interrupted = true;
      // As an evaluator does: nothing of a block that is given up.
      if (blocks > 20) {
        while (!*stopped) std::this_thread::sleep_for(1ms);
        return std::optional<problems::StudyBlock>();
      }
      return std::optional(sample_block(first, count));
    };
  };
  const auto part = run_once(folder / "a.db", study, interrupting, 3, interrupted);
  EXPECT_EQ(part.end, StudyEnd::interrupted);
  EXPECT_EQ(part.counts.evaluated, 20 * 64);
  interrupted = false;
  EXPECT_EQ(run_once(folder / "a.db", study, sample_evaluators(), 3, interrupted).counts.evaluated,
            5000);
  run_once(folder / "whole.db", study, sample_evaluators(), 1, interrupted);
  EXPECT_EQ(all_rows(folder / "a.db"), all_rows(folder / "whole.db"));
}

TEST(StudyRun, IsNotDoneWhereAnEvaluatorGaveUp) {
  const TestFolder folder;
  const EvaluatorMaker failing = [](const std::atomic<bool>*) {
    return [](std::int64_t first, std::int64_t count) {
      return first < 640 ? std::optional(sample_block(first, count)) : std::nullopt;
    };
  };
  const std::atomic<bool> interrupted{false};
  const auto ran = run_once(folder / "a.db", sample_study(5000), failing, 1, interrupted);
  EXPECT_EQ(ran.end, StudyEnd::interrupted);
  EXPECT_EQ(ran.counts.evaluated, 640);
}

TEST(StudyRun, EndsAtTheTimeLimit) {
  const TestFolder folder;
  const EvaluatorMaker endless = [](const std::atomic<bool>* stopped) {
    return [stopped](std::int64_t, std::int64_t) {
      while (!*stopped) std::this_thread::sleep_for(1ms);
      return std::optional<problems::StudyBlock>();
    };
  };
  const std::atomic<bool> interrupted{false};
  const auto ran = run_once(folder / "a.db", sample_study(100), endless, 2, interrupted, 0.01);
  EXPECT_EQ(ran.end, StudyEnd::time_limit);
  EXPECT_EQ(ran.counts.evaluated, 0);
}

TEST(StudyRun, ThrowsWhatAnEvaluatorThrew) {
  const TestFolder folder;
  const EvaluatorMaker throwing = [](const std::atomic<bool>*) {
    return [](std::int64_t first, std::int64_t count) {
      if (first == 640) throw std::runtime_error("a fault");
      return std::optional(sample_block(first, count));
    };
  };
  const std::atomic<bool> interrupted{false};
  EXPECT_THROW(run_once(folder / "a.db", sample_study(5000), throwing, 3, interrupted),
               std::runtime_error);
}

TEST(StudyRun, EvaluatorsWaitForTheWriter) {
  std::atomic<int> evaluated{0};
  const EvaluatorMaker counting = [&](const std::atomic<bool>*) {
    return [&](std::int64_t first, std::int64_t count) {
      ++evaluated;
      return std::optional(sample_block(first, count));
    };
  };
  WorkList work({{0, 100'000}}, 10);
  ThreadCrew crew(
      counting, [&] { return work.next(); }, 2);
  // Until each thread holds a block for which there is no room.
  while (evaluated < 6) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(evaluated, 6);
  std::int64_t designs = 0;
  crew.stop();
  while (!crew.is_finished()) {
    if (const auto block = crew.wait(1ms)) designs += block->count;
  }
  EXPECT_EQ(designs, 10 * evaluated);
}

TEST(BlockMessage, ComesBackWhole) {
  const auto block = sample_block(3, 50);
  const auto message = block_message(block);
  const auto back = block_of(message);
  EXPECT_EQ(back.first, 3);
  EXPECT_EQ(back.count, 50);
  EXPECT_EQ(back.filtered, block.filtered);
  EXPECT_EQ(back.ids, block.ids);
  EXPECT_EQ(back.statuses, block.statuses);
  EXPECT_EQ(back.cells, block.cells);
  for (std::size_t size = 0; size < message.size(); ++size) {
    EXPECT_THROW(block_of(std::span(message).first(size)), std::out_of_range) << size;
  }
}

TEST(WorkList, HandsOutGapsInBlocks) {
  WorkList work({{0, 5}, {10, 3}}, 4);
  EXPECT_EQ(work.next(), (DesignRange{0, 4}));
  EXPECT_EQ(work.next(), (DesignRange{4, 1}));
  EXPECT_EQ(work.next(), (DesignRange{10, 3}));
  EXPECT_EQ(work.next(), std::nullopt);
}

TEST(StudyProgress, SaysHowManyHowFastAndHowLong) {
  EXPECT_EQ(progress_words(1'234'000, 10'000'000, 52'345.6),
            "1 234 000 of 10 000 000 designs, 52 000/s, 2:48 left");
  EXPECT_EQ(progress_words(0, 12, 0), "0 of 12 designs");
  EXPECT_EQ(progress_words(2, 12, 1.25), "2 of 12 designs, 1.2/s, 0:08 left");
  EXPECT_EQ(progress_words(0, 36'000, 1), "0 of 36 000 designs, 1/s, 10 h 00 min left");
  EXPECT_EQ(progress_words(0, std::numeric_limits<std::int64_t>::max(), 1e-3),
            "0 of 9 223 372 036 854 775 807 designs, 0.001/s, 11574 days left");
}

}  // namespace
}  // namespace cognate::app::study_run_test
