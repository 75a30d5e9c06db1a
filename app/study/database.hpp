/// @file The study file: an SQLite database with the definition of a study and its rows.
///
/// Tables: `study` (name, value: the definition), `runs` (`id`, a column for each varied key and
/// metric, `status`), `blocks` (which designs have been evaluated, and how they came out),
/// `checksums` (of each block with its rows), `front` (the ids on the Pareto front); view `best`.
/// Columns of numbers have no declared type, because SQLite then stores every double as it is, −0
/// included.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/study/design_range.hpp"
#include "app/study/front.hpp"
#include "app/study/sqlite.hpp"
#include "problems/study/block.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

/// Why a study file cannot be used, as a sentence for the user.
class StudyFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What rows depend on apart from the study itself.
struct StudyOrigin {
  std::string text;  ///< of the study file
  std::string version;
  std::uint64_t seed = 1;
};

/// How many designs came out how. Those kept are counted by status as well.
struct StudyCounts {
  std::int64_t evaluated = 0;
  std::int64_t kept = 0;
  std::int64_t filtered = 0;  ///< did not pass, whether or not kept
  std::int64_t solved = 0;
  std::int64_t infeasible = 0;
  std::int64_t no_solution = 0;
  std::int64_t invalid = 0;
};

/// The one writer of a study file. Blocks are gathered into a transaction and committed half a
/// second later or after some ten thousand rows: what has been committed survives whichever way the
/// process ends, and a block is there with all its rows or not at all. Every member throws a
/// StudyFileError where the file cannot be read or written; what had been committed is then there.
class StudyDatabase {
 public:
  /// Opens the study file, or makes it where there is none; only to read, it is not changed. Throws
  /// where the file is of another study, text, version or seed, damaged, or no study file at all.
  StudyDatabase(std::filesystem::path file, const problems::Study& study, const StudyOrigin& origin,
                SqliteDatabase::Access access = SqliteDatabase::Access::write_or_create);
  StudyDatabase(const StudyDatabase&) = delete;
  StudyDatabase& operator=(const StudyDatabase&) = delete;

  /// The designs of which no block is stored, ascending.
  std::vector<DesignRange> missing();

  void store(const problems::StudyBlock& block);
  /// Every block that is stored, ascending, while `take` gives true.
  void for_each_block(const std::function<bool(const problems::StudyBlock&)>& take);
  /// Commits where that is due.
  void tick();
  void commit();

  const StudyCounts& counts() const { return counts_; }
  /// How many of the blocks that were there at the opening have no checksum.
  std::int64_t unchecked_blocks() const { return unchecked_blocks_; }
  const std::filesystem::path& file() const { return file_; }
  SqliteDatabase& connection() { return connection_; }

 private:
  template <class Body>
  auto guarded(Body&& body);
  void create(const problems::Study& study,
              const std::vector<std::pair<std::string, std::string>>& identity);
  void prepare();
  void insert_rows(const problems::StudyBlock& block);
  void insert_block(const problems::StudyBlock& block);
  void update_front(const problems::StudyBlock& block);
  void keep_a_log();
  void check_whole();
  void check_schema(const problems::Study& study);
  void check_blocks();
  void load_counts();
  void load_front();

  std::filesystem::path file_;
  std::int64_t designs_;
  std::size_t width_;                                       ///< of a row, in cells
  std::vector<std::pair<std::size_t, double>> objectives_;  ///< column, and −1 for the greatest
  SqliteDatabase connection_;
  std::optional<SqliteStatement> insert_row_, insert_block_, insert_sum_, insert_front_,
      delete_front_;
  StudyFront front_;
  StudyCounts counts_;
  std::int64_t unchecked_blocks_ = 0;
  std::int64_t uncommitted_rows_ = 0;
  std::chrono::steady_clock::time_point begun_;
};

}  // namespace cognate::app
