/// What a study file is put to when it is opened; each throws a SqliteError (SQLITE_CORRUPT).
#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>

#include "app/study/database.hpp"
#include "app/study/read_rows.hpp"
#include "app/study/schema.hpp"

namespace cognate::app {

/// Finds damage of the file as a database, and tables that are not there.
void StudyDatabase::check_whole() {
  const auto found = connection_.text("PRAGMA integrity_check(1)");
  if (found != "ok") throw SqliteError(SQLITE_CORRUPT, found);
  for (const char* table : {"study", "runs", "blocks", "front", "best"}) {
    const auto count = fmt::format("SELECT count(*) FROM sqlite_master WHERE name = '{}'", table);
    if (connection_.integer(count) == 0) {
      throw SqliteError(SQLITE_CORRUPT, fmt::format("it has no table {}", table));
    }
  }
}

/// Finds tables and a view that are others than those of the study: a changed name of a column
/// would be a word in every row.
void StudyDatabase::check_schema(const problems::Study& study) {
  auto stored = connection_.prepare(
      "SELECT sql FROM sqlite_master WHERE sql IS NOT NULL AND name <> 'checksums' ORDER BY rowid");
  std::vector<std::string> statements;
  while (stored.step()) statements.push_back(stored.text(0));
  if (statements != study_schema(study)) {
    throw SqliteError(SQLITE_CORRUPT, "its tables are not those of the study");
  }
}

void StudyDatabase::check_blocks() {
  // Those of a list in order that begin before the end of the one before, or leave the study.
  auto wrong = connection_.prepare(
      "SELECT 1 FROM (SELECT first, count, lag(first + count, 1, 0) OVER (ORDER BY first) AS free"
      " FROM blocks) WHERE first < free OR count < 1 OR count > ?1 OR first > ?1 - count");
  wrong.bind(1, designs_);
  if (wrong.step()) throw SqliteError(SQLITE_CORRUPT, "its blocks overlap, or are of no design");
}

void StudyDatabase::load_front() {
  if (objectives_.empty()) return;
  // From the rows, which their checksums vouch for: nothing vouches for the stored one.
  front_ = front_of_rows(connection_, objectives_);
  std::vector<std::int64_t> ids;
  for (const auto& member : front_.points()) ids.push_back(member.id);
  std::ranges::sort(ids);
  std::vector<std::int64_t> stored;
  auto front = connection_.prepare("SELECT id FROM front ORDER BY id");
  while (front.step()) stored.push_back(front.integer(0));
  if (ids != stored) throw SqliteError(SQLITE_CORRUPT, "its front is not that of its rows");
}

}  // namespace cognate::app
