/// @file Checksums of the blocks of a study file, by which a changed row is found.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/study/sqlite.hpp"
#include "problems/study/block.hpp"

namespace cognate::app {

/// 64 bits of a sequence of values. Every step is one to one in the sum and in the value, so that
/// sequences that differ in a single 64-bit word never have the same sum.
class Checksum {
 public:
  void add(std::uint64_t word);
  void add(std::string_view text);
  /// A number by its bits: −0 is not 0.
  void add(const problems::Cell& cell);
  /// As SQLite stores it.
  std::int64_t value() const { return static_cast<std::int64_t>(sum_); }

 private:
  std::uint64_t sum_ = 0x243F6A8885A308D3;  // the first bits of π's fraction
};

/// The counts of a block in the order of the columns of `blocks` from `count` on, as they enter its
/// checksum: evaluated, kept, filtered, solved, infeasible, no solution, invalid.
inline constexpr int kBlockCounts = 7;

/// The statement that makes the table of checksums where there is none.
inline constexpr const char* kChecksumTable =
    "CREATE TABLE IF NOT EXISTS checksums (first INTEGER PRIMARY KEY, sum INTEGER NOT NULL)";

/// The columns of `blocks` and what `checksums` has of them, as files of columns have them:
/// `first`, the counts, `has_checksum`, `checksum`.
inline constexpr std::size_t kBlockColumns = kBlockCounts + 3;
const std::array<const char*, kBlockColumns>& block_columns();

/// The checksum of texts and their names, as of the table `study`.
std::int64_t texts_checksum(const std::vector<std::pair<std::string, std::string>>& texts);

/// Checks that the rows in a study file are those that were stored, by the checksums
/// of all blocks, or of that of one `design`. Gives the number of blocks that have none, stored by
/// a version without checksums. Throws a SqliteError (SQLITE_CORRUPT) that names the designs of the
/// first block whose rows differ.
std::int64_t check_rows(SqliteDatabase& database,
                        std::optional<std::int64_t> design = std::nullopt);

}  // namespace cognate::app
