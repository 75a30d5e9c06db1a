#include "app/study/database.hpp"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <variant>

#include "app/study/checksum.hpp"
#include "app/study/read_columns.hpp"
#include "app/study/read_rows.hpp"
#include "app/study/schema.hpp"
#include "problems/study/names.hpp"

namespace cognate::app {
namespace {

using problems::Cell;
using problems::RunStatus;
using problems::StudyBlock;
using Identity = std::vector<std::pair<std::string, std::string>>;

constexpr auto kCommitPeriod = std::chrono::milliseconds(500);
constexpr std::int64_t kCommitRows = 50'000;

/// What SQLite's error means for a study, and what helps.
std::string explained(const SqliteError& error, const std::filesystem::path& file) {
  const auto name = file.string();
  if (is_columns_file(file) && error.code() == SQLITE_CORRUPT) {
    return fmt::format("'{}' is damaged ({}); write it again by --format hdf5", name, error.what());
  }
  switch (error.code()) {
    case SQLITE_NOTADB:
      return fmt::format("'{}' is no study file; move it away, or give another folder by --out",
                         name);
    case SQLITE_CORRUPT:
      return fmt::format(
          "'{}' is damaged ({}); move it away to begin anew ('sqlite3 FILE .recover' may save "
          "rows)",
          name, error.what());
    case SQLITE_FULL:
    case SQLITE_IOERR:
      return fmt::format(
          "cannot store rows in '{}': {}; the rows so far are there, and the same command "
          "continues "
          "once there is room",
          name, error.what());
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      return fmt::format("cannot write '{}': {}; give another folder by --out", name, error.what());
    case SQLITE_CONSTRAINT:  // rows that were not there when it was opened
      return fmt::format(
          "'{}' was changed by another program while the study ran ({}); run the command again "
          "once that has ended",
          name, error.what());
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return fmt::format(
          "'{}' is held by another program that changes it; end that, and run the command again",
          name);
    default:
      return fmt::format("cannot use '{}': {}", name, error.what());
  }
}

Identity stored_identity(SqliteDatabase& connection) {
  Identity identity;
  auto rows = connection.prepare("SELECT name, value FROM study ORDER BY rowid");
  while (rows.step()) identity.emplace_back(rows.text(0), rows.text(1));
  return identity;
}

void count_row(StudyCounts& counts, RunStatus status) {
  switch (status) {
    case RunStatus::solved:
      ++counts.solved;
      break;
    case RunStatus::infeasible:
      ++counts.infeasible;
      break;
    case RunStatus::no_solution:
      ++counts.no_solution;
      break;
    case RunStatus::invalid:
      ++counts.invalid;
      break;
    case RunStatus::filtered:
      break;
  }
}

StudyCounts counts_of(const StudyBlock& block) {
  StudyCounts counts{.evaluated = block.count,
                     .kept = static_cast<std::int64_t>(block.ids.size()),
                     .filtered = block.filtered};
  for (const auto status : block.statuses) count_row(counts, status);
  return counts;
}

/// The counts in the order of the columns of `blocks`, from `count` on.
std::array<std::int64_t*, 7> fields(StudyCounts& counts) {
  return {&counts.evaluated,  &counts.kept,        &counts.filtered, &counts.solved,
          &counts.infeasible, &counts.no_solution, &counts.invalid};
}

/// As check_rows() finds it again in the file.
std::int64_t checksum_of(const StudyBlock& block, std::size_t width) {
  Checksum sum;
  sum.add(static_cast<std::uint64_t>(block.first));
  auto counts = counts_of(block);
  for (const auto* count : fields(counts)) sum.add(static_cast<std::uint64_t>(*count));
  for (std::size_t row = 0; row < block.ids.size(); ++row) {
    sum.add(static_cast<std::uint64_t>(block.ids[row]));
    for (std::size_t i = 0; i < width; ++i) sum.add(block.cells[row * width + i]);
    sum.add(Cell(std::string(problems::to_string(block.statuses[row]))));
  }
  return sum.value();
}

}  // namespace

/// Calls `body`, and says its errors of SQLite as those of a study file, with nothing half stored.
template <class Body>
auto StudyDatabase::guarded(Body&& body) {
  try {
    return body();
  } catch (const SqliteError& error) {
    const auto what = explained(error, file_);
    // SQLite may have rolled back by itself, or be unable to.
    if (connection_.in_transaction()) {
      try {
        connection_.execute("ROLLBACK");
      } catch (const SqliteError&) {
        throw StudyFileError(what);
      }
    }
    throw StudyFileError(what);
  }
}

namespace {

SqliteDatabase opened(const std::filesystem::path& file, SqliteDatabase::Access access) {
  try {
    if (access == SqliteDatabase::Access::read) return study_rows(file);
    return {file, access};
  } catch (const SqliteError& error) {
    throw StudyFileError(explained(error, file));
  }
}

}  // namespace

StudyDatabase::StudyDatabase(std::filesystem::path file, const problems::Study& study,
                             const StudyOrigin& origin, SqliteDatabase::Access access)
    : file_(std::move(file)),
      designs_(problems::design_count(study)),
      width_(problems::study_columns(study).size()),
      objectives_(objective_columns(study)),
      connection_(opened(file_, access)) {
  guarded([&] {
    const auto identity = study_identity(study, origin);
    const bool writes = access == SqliteDatabase::Access::write_or_create;
    const auto application = connection_.integer("PRAGMA application_id");
    const bool is_new = writes && application == 0 &&
                        connection_.integer("SELECT count(*) FROM sqlite_master") == 0;
    if (!is_new && application != kStudyApplicationId) {
      throw StudyFileError(explained(SqliteError(SQLITE_NOTADB, ""), file_));
    }
    if (writes) keep_a_log();
    if (is_new) create(study, identity);
    check_whole();
    const auto difference = study_difference(stored_identity(connection_), identity);
    if (!difference.empty()) {
      throw StudyFileError(
          fmt::format("'{}' was begun with other input: {} differs; remove it to begin anew, or "
                      "give another folder by --out",
                      file_.string(), difference));
    }
    check_schema(study);
    if (writes) connection_.execute(kChecksumTable);
    check_blocks();
    load_counts();
    unchecked_blocks_ = check_rows(connection_);
    load_front();
    if (writes) prepare();
  });
}

/// What is committed survives the process, and is read while it is written.
void StudyDatabase::keep_a_log() {
  if (connection_.text("PRAGMA journal_mode = WAL") != "wal") {
    throw StudyFileError(fmt::format(
        "'{}': the file system has no shared memory for SQLite's write-ahead log; give a folder "
        "on another one by --out",
        file_.string()));
  }
  connection_.execute("PRAGMA synchronous = NORMAL");
}

void StudyDatabase::create(const problems::Study& study, const Identity& identity) {
  connection_.execute("BEGIN IMMEDIATE");
  connection_.execute(fmt::format("PRAGMA application_id = {}", kStudyApplicationId));
  for (const auto& statement : study_schema(study)) connection_.execute(statement);
  auto insert = connection_.prepare("INSERT INTO study VALUES (?, ?)");
  for (const auto& [name, value] : identity) {
    insert.bind(1, std::string_view(name));
    insert.bind(2, std::string_view(value));
    insert.run();
  }
  connection_.execute("COMMIT");
}

void StudyDatabase::prepare() {
  std::string places = "?, ?";
  for (std::size_t i = 0; i < width_; ++i) places += ", ?";
  insert_row_ = connection_.prepare("INSERT INTO runs VALUES (" + places + ")");
  insert_block_ = connection_.prepare("INSERT INTO blocks VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  insert_sum_ = connection_.prepare("INSERT INTO checksums VALUES (?, ?)");
  insert_front_ = connection_.prepare("INSERT INTO front VALUES (?)");
  delete_front_ = connection_.prepare("DELETE FROM front WHERE id = ?");
}

void StudyDatabase::load_counts() {
  auto sums = connection_.prepare(
      "SELECT sum(count), sum(kept), sum(filtered), sum(solved), sum(infeasible),"
      " sum(no_solution), sum(invalid) FROM blocks");
  sums.step();
  int column = 0;
  for (auto* field : fields(counts_)) *field = sums.integer(column++);
  if (connection_.integer("SELECT count(*) FROM runs") != counts_.kept) {
    throw SqliteError(SQLITE_CORRUPT, "its rows are not those of its blocks");
  }
}

std::vector<DesignRange> StudyDatabase::missing() {
  return guarded([&] {
    std::vector<DesignRange> gaps;
    std::int64_t next = 0;
    const auto close_gap = [&](std::int64_t end) {
      if (end > next) gaps.push_back({next, end - next});
    };
    auto blocks = connection_.prepare("SELECT first, count FROM blocks ORDER BY first");
    while (blocks.step()) {
      close_gap(blocks.integer(0));
      next = blocks.integer(0) + blocks.integer(1);
    }
    close_gap(designs_);
    return gaps;
  });
}

void StudyDatabase::store(const StudyBlock& block) {
  guarded([&] {
    if (!connection_.in_transaction()) {
      connection_.execute("BEGIN IMMEDIATE");
      begun_ = std::chrono::steady_clock::now();
    }
    insert_rows(block);
    insert_block(block);
    if (!objectives_.empty()) update_front(block);
    uncommitted_rows_ += static_cast<std::int64_t>(block.ids.size());
  });
  if (uncommitted_rows_ >= kCommitRows) commit();
}

void StudyDatabase::for_each_block(const std::function<bool(const StudyBlock&)>& take) {
  guarded([&] {
    auto blocks = connection_.prepare("SELECT first, count, filtered FROM blocks ORDER BY first");
    auto rows = connection_.prepare("SELECT * FROM runs WHERE id >= ? AND id < ? ORDER BY id");
    while (blocks.step()) {
      StudyBlock block{
          .first = blocks.integer(0), .count = blocks.integer(1), .filtered = blocks.integer(2)};
      rows.bind(1, block.first);
      rows.bind(2, block.first + block.count);
      while (rows.step()) add_row(block, rows, static_cast<int>(width_));
      rows.reset();
      if (!take(block)) return;
    }
  });
}

void StudyDatabase::insert_rows(const StudyBlock& block) {
  auto& insert = *insert_row_;
  const auto status_place = static_cast<int>(width_) + 2;
  for (std::size_t row = 0; row < block.ids.size(); ++row) {
    insert.bind(1, block.ids[row]);
    for (std::size_t i = 0; i < width_; ++i) {
      insert.bind(static_cast<int>(i) + 2, block.cells[row * width_ + i]);
    }
    insert.bind(status_place, problems::to_string(block.statuses[row]));
    insert.run();
  }
}

void StudyDatabase::insert_block(const StudyBlock& block) {
  auto counts = counts_of(block);
  insert_block_->bind(1, block.first);
  int place = 2;
  const auto total = fields(counts_);
  const auto part = fields(counts);
  for (std::size_t i = 0; i < part.size(); ++i) {
    insert_block_->bind(place++, *part[i]);
    *total[i] += *part[i];
  }
  insert_block_->run();
  insert_sum_->bind(1, block.first);
  insert_sum_->bind(2, checksum_of(block, width_));
  insert_sum_->run();
}

void StudyDatabase::update_front(const StudyBlock& block) {
  // The front of the block alone first: it is short, and only it meets the whole front.
  StudyFront candidates;
  std::vector<std::int64_t> left;
  StudyFront::Point point{.objectives = std::vector<double>(objectives_.size())};
  for (std::size_t row = 0; row < block.ids.size(); ++row) {
    bool has_all = block.statuses[row] == RunStatus::solved;
    for (std::size_t i = 0; i < objectives_.size() && has_all; ++i) {
      const auto& [column, sign] = objectives_[i];
      const auto* value = std::get_if<double>(&block.cells[row * width_ + column]);
      has_all = value != nullptr;
      if (has_all) point.objectives[i] = sign * *value;
    }
    point.id = block.ids[row];
    if (has_all) candidates.add(point, left);
  }
  left.clear();
  for (const auto& candidate : candidates.points()) {
    if (!front_.add(candidate, left)) continue;
    insert_front_->bind(1, candidate.id);
    insert_front_->run();
  }
  for (const auto id : left) {
    delete_front_->bind(1, id);
    delete_front_->run();
  }
}

void StudyDatabase::tick() {
  if (connection_.in_transaction() && std::chrono::steady_clock::now() >= begun_ + kCommitPeriod) {
    commit();
  }
}

void StudyDatabase::commit() {
  if (connection_.has_moved()) {
    throw StudyFileError(
        fmt::format("'{}' was removed or replaced while the study ran; rows since then are lost",
                    file_.string()));
  }
  guarded([&] {
    if (connection_.in_transaction()) connection_.execute("COMMIT");
  });
  uncommitted_rows_ = 0;
}

}  // namespace cognate::app
