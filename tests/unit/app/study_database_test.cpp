/// @file Study files: what is stored comes back to the bit, goes on where it stopped, and is
/// refused where it is another one's.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "app/study/database.hpp"
#include "app/study/lock.hpp"
#include "app/study/read_rows.hpp"
#include "tests/support/study_samples.hpp"

namespace cognate::app::study_database_test {
namespace {

using problems::Cell;
using problems::RunStatus;
using problems::Study;
using problems::StudyBlock;
using tests::sample_block;
using tests::sample_study;
using tests::TestFolder;

const StudyOrigin kOrigin{.text = "base = 'base.toml'\n", .version = "1.2.3", .seed = 4};

std::vector<std::string> strings(const std::filesystem::path& file, const char* sql) {
  SqliteDatabase database(file, SqliteDatabase::Access::read);
  auto rows = database.prepare(sql);
  std::vector<std::string> texts;
  while (rows.step()) texts.push_back(rows.text(0));
  return texts;
}

/// The message with which the file is refused; empty if it is not.
std::string refusal(const std::filesystem::path& file, const Study& study,
                    const StudyOrigin& origin) {
  try {
    StudyDatabase database(file, study, origin);
  } catch (const StudyFileError& error) {
    return error.what();
  }
  return "";
}

TEST(StudyDatabase, KeepsEveryDoubleToTheBit) {
  const TestFolder folder;
  using Limits = std::numeric_limits<double>;
  const std::vector<double> numbers = {
      0.0,           -0.0,          1.0,    -3.0,   0.1,     1e300,  Limits::denorm_min(),
      Limits::max(), Limits::min(), 0x1p53, 0x1p63, -0x1p63, 1.0 / 3};
  auto study = sample_study(static_cast<std::int64_t>(numbers.size()));
  StudyBlock block{.count = static_cast<std::int64_t>(numbers.size())};
  for (const double number : numbers) {
    block.ids.push_back(static_cast<std::int64_t>(block.ids.size()));
    block.statuses.push_back(RunStatus::solved);
    block.cells.insert(block.cells.end(),
                       {Cell(number), Cell(), Cell(number), Cell(std::string("ü'\""))});
  }
  StudyDatabase database(folder / "a.study.db", study, kOrigin);
  database.store(block);
  database.commit();
  const auto rows = report_rows(database.connection(), study, 100);
  ASSERT_EQ(rows.ids, block.ids);
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    ASSERT_EQ(rows.cells[i].index(), block.cells[i].index());
    const auto* number = std::get_if<double>(&rows.cells[i]);
    if (number == nullptr) {
      EXPECT_EQ(rows.cells[i], block.cells[i]);
    } else {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(*number),
                std::bit_cast<std::uint64_t>(std::get<double>(block.cells[i])));
    }
  }
}

TEST(StudyDatabase, GoesOnWithWhatIsMissing) {
  const TestFolder folder;
  const auto study = sample_study(100);
  {
    StudyDatabase database(folder / "a.study.db", study, kOrigin);
    EXPECT_EQ(database.missing(), (std::vector<DesignRange>{{0, 100}}));
    database.store(sample_block(10, 20));
    database.store(sample_block(50, 50));
    database.commit();
    database.store(sample_block(30, 5));  // not committed: rolled back
  }
  StudyDatabase database(folder / "a.study.db", study, kOrigin);
  EXPECT_EQ(database.missing(), (std::vector<DesignRange>{{0, 10}, {30, 20}}));
  EXPECT_EQ(database.counts().evaluated, 70);
  EXPECT_EQ(database.counts().filtered, 10);  // 14, 21, 28, 56, …, 98
  EXPECT_EQ(database.counts().kept, 60);
  EXPECT_EQ(database.counts().infeasible, 6);  // 11, 22, 55, 66, 88, 99; 77 is filtered
  EXPECT_EQ(database.counts().solved, 54);
}

TEST(StudyDatabase, IsTheSameInAnyOrderOfBlocks) {
  const TestFolder folder;
  const auto study =
      sample_study(1000, {{.name = "a.first"}, {.name = "second", .greatest = true}});
  StudyDatabase upwards(folder / "up.study.db", study, kOrigin);
  StudyDatabase downwards(folder / "down.study.db", study, kOrigin);
  for (std::int64_t i = 0; i < 10; ++i) {
    upwards.store(sample_block(100 * i, 100));
    downwards.store(sample_block(900 - 100 * i, 100));
  }
  upwards.commit();
  downwards.commit();
  const char* row =
      "SELECT id || ' ' || quote(\"a.first\") || quote(second) || class || status FROM ";
  for (const std::string table : {"runs ORDER BY id", "best"}) {
    const auto rows = strings(folder / "up.study.db", (row + table).c_str());
    EXPECT_GT(rows.size(), 3U);
    EXPECT_EQ(rows, strings(folder / "down.study.db", (row + table).c_str()));
  }
}

TEST(StudyDatabase, ViewBestIsWhatTheObjectivesSay) {
  const TestFolder folder;
  // Whether the view has the rows that `sql` says.
  const auto expect = [&](const char* name, const Study& study, const char* sql) {
    StudyDatabase database(folder / name, study, kOrigin);
    database.store(sample_block(0, 500));
    database.commit();
    const auto best = strings(folder / name, "SELECT id FROM best");
    EXPECT_GT(best.size(), 3U);
    EXPECT_EQ(best, strings(folder / name, sql)) << name;
  };
  expect("none.db", sample_study(500), "SELECT id FROM runs WHERE status = 'solved' ORDER BY id");
  expect("one.db", sample_study(500, {{.name = "second", .greatest = true}}),
         "SELECT id FROM runs WHERE status = 'solved' AND second IS NOT NULL ORDER BY second DESC");
  // The front by its definition.
  expect("two.db", sample_study(500, {{.name = "second", .greatest = true}, {.name = "a.first"}}),
         "SELECT id FROM runs r WHERE status = 'solved' AND second IS NOT NULL AND NOT EXISTS "
         "(SELECT 1 FROM runs q WHERE q.status = 'solved' AND q.second >= r.second AND "
         "q.\"a.first\" <= r.\"a.first\" AND q.id <> r.id) ORDER BY second DESC");
}

TEST(StudyDatabase, FrontSurvivesReopening) {
  const TestFolder folder;
  const auto study = sample_study(600, {{.name = "a.first"}, {.name = "second"}});
  const auto store = [&](const char* name, bool reopen) {
    std::optional<StudyDatabase> database;
    for (std::int64_t i = 0; i < 6; ++i) {
      if (!database || reopen) {
        database.reset();
        database.emplace(folder / name, study, kOrigin);
      }
      database->store(sample_block(100 * i, 100));
      database->commit();
    }
    database.reset();
    return strings(folder / name, "SELECT id FROM front ORDER BY id");
  };
  EXPECT_EQ(store("once.db", false), store("again.db", true));
}

TEST(StudyDatabase, RefusesWhatIsAnothers) {
  const TestFolder folder;
  const auto file = folder / "a.study.db";
  const auto study = sample_study(10);
  ASSERT_EQ(refusal(file, study, kOrigin), "");
  EXPECT_EQ(refusal(file, study, kOrigin), "");
  const auto expect = [&](const Study& other, const StudyOrigin& origin, const char* what) {
    const auto message = refusal(file, other, origin);
    EXPECT_NE(message.find(what), std::string::npos) << message;
    EXPECT_NE(message.find("; remove it"), std::string::npos) << message;
  };
  auto origin = kOrigin;
  origin.seed = 5;
  expect(study, origin, "the seed (4 there, 5 here) differs");
  origin = kOrigin;
  origin.version = "2.0.0";
  expect(study, origin, "the version of Cognate (1.2.3 there, 2.0.0 here)");
  origin = kOrigin;
  origin.text += "# more\n";
  expect(study, origin, "the study file (from line 2 on)");
  auto other = study;
  other.base_text = "crank = 2\n";
  expect(other, kOrigin, "the base file (from line 1 on)");
  other = study;
  other.drawing = "M 0 0 L 1 0 L 0 1 Z";
  expect(other, kOrigin, "the drawing that the base file names differs");
  other = study;
  other.metrics.pop_back();
  expect(other, kOrigin, "its columns");
}

TEST(StudyDatabase, RefusesWhatIsNoStudyFile) {
  const TestFolder folder;
  const auto study = sample_study(10);
  std::ofstream(folder / "text.db") << std::string(10'000, 'x');
  EXPECT_NE(refusal(folder / "text.db", study, kOrigin).find("is no study file; "),
            std::string::npos);
  SqliteDatabase(folder / "other.db", SqliteDatabase::Access::write_or_create)
      .execute("CREATE TABLE runs (id)");
  EXPECT_NE(refusal(folder / "other.db", study, kOrigin).find("is no study file; "),
            std::string::npos);
  std::filesystem::create_directory(folder / "folder.db");
  EXPECT_NE(refusal(folder / "folder.db", study, kOrigin), "");
}

TEST(StudyDatabase, SaysWhenItsFileIsGone) {
  const TestFolder folder;
  const auto study = sample_study(100);
  StudyDatabase database(folder / "a.study.db", study, kOrigin);
  database.store(sample_block(0, 10));
  database.commit();
  std::filesystem::remove(folder / "a.study.db");
  database.store(sample_block(10, 10));
  EXPECT_THROW(database.commit(), StudyFileError);
}

TEST(StudyRows, ReportsTheBestAndAnEvenSelection) {
  const TestFolder folder;
  const auto study = sample_study(7000, {{.name = "a.first"}});
  StudyDatabase database(folder / "a.study.db", study, kOrigin);
  database.store(sample_block(0, 7000));
  database.commit();
  const auto rows = report_rows(database.connection(), study, 200);
  EXPECT_EQ(rows.total, 6000);
  EXPECT_LE(rows.ids.size(), 200U);
  EXPECT_GT(rows.ids.size(), 190U);
  EXPECT_TRUE(std::ranges::is_sorted(rows.ids));
  EXPECT_EQ(std::ranges::count(rows.best, true), 10);
  // Every tenth of the designs has its share.
  for (std::int64_t i = 0; i < 10; ++i) {
    EXPECT_GT(std::ranges::count_if(rows.ids, [&](auto id) { return id / 700 == i; }), 5);
  }
  const auto best = best_rows(database.connection(), study, 3);
  EXPECT_EQ(best.ids.size(), 3U);
  for (const auto id : best.ids) EXPECT_TRUE(std::ranges::binary_search(rows.ids, id));
  EXPECT_FALSE(row_of(database.connection(), study, 7));  // filtered
  ASSERT_TRUE(row_of(database.connection(), study, 8));
  EXPECT_EQ(row_of(database.connection(), study, 8)->cells[1], Cell(tests::scattered(8, 1)));
}

TEST(StudyLock, IsTakenOnce) {
  const TestFolder folder;
  const auto file = folder / "a.lock";
  {
    const auto first = StudyLock::take(file);
    ASSERT_TRUE(first) << first.error();
    const auto second = StudyLock::take(file);
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().find("process " + std::to_string(getpid())), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_TRUE(StudyLock::take(file));
}

}  // namespace
}  // namespace cognate::app::study_database_test
