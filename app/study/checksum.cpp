#include "app/study/checksum.hpp"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <variant>

namespace cognate::app {
namespace {

/// The sum of block `block`, whose rows are the next ones of `rows`: those before `end`.
std::int64_t sum_of(const SqliteStatement& block, SqliteStatement& rows, bool& has_row,
                    std::int64_t end) {
  Checksum sum;
  sum.add(static_cast<std::uint64_t>(block.integer(0)));
  for (int i = 1; i <= kBlockCounts; ++i) sum.add(static_cast<std::uint64_t>(block.integer(i)));
  for (; has_row && rows.integer(0) < end; has_row = rows.step()) {
    sum.add(static_cast<std::uint64_t>(rows.integer(0)));
    for (int i = 1; i < rows.columns(); ++i) sum.add(rows.cell(i));
  }
  return sum.value();
}

/// The sums beside the blocks, null where a block has none.
SqliteStatement blocks_with_sums(SqliteDatabase& database, std::optional<std::int64_t> design) {
  const bool has_sums =
      database.integer("SELECT count(*) FROM sqlite_master WHERE name = 'checksums'") > 0;
  const auto of_design =
      design ? fmt::format(" WHERE b.first <= {0} AND b.first > {0} - b.count", *design) : "";
  return database.prepare(
      fmt::format("SELECT b.*, {} ORDER BY b.first",
                  (has_sums ? "c.sum FROM blocks b LEFT JOIN checksums c ON c.first = b.first"
                            : "NULL FROM blocks b") +
                      of_design));
}

}  // namespace

void Checksum::add(std::uint64_t word) {
  sum_ = (sum_ ^ word) * 0x9E3779B97F4A7C15U;
  sum_ ^= sum_ >> 32U;
}

void Checksum::add(std::string_view text) {
  add(std::uint64_t{text.size()});
  for (std::size_t i = 0; i < text.size(); i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, text.data() + i, std::min(sizeof word, text.size() - i));
    add(word);
  }
}

void Checksum::add(const problems::Cell& cell) {
  const auto* number = std::get_if<double>(&cell);
  const bool is_stored = number == nullptr || std::isfinite(*number);  // else as nothing
  add(is_stored ? std::uint64_t{cell.index()} : 0);
  if (number != nullptr && is_stored) add(std::bit_cast<std::uint64_t>(*number));
  if (const auto* word = std::get_if<std::string>(&cell)) add(std::string_view(*word));
}

const std::array<const char*, kBlockColumns>& block_columns() {
  static constexpr std::array<const char*, kBlockColumns> kNames{
      "first",      "count",       "kept",    "filtered",     "solved",
      "infeasible", "no_solution", "invalid", "has_checksum", "checksum"};
  return kNames;
}

std::int64_t texts_checksum(const std::vector<std::pair<std::string, std::string>>& texts) {
  Checksum sum;
  for (const auto& [name, text] : texts) {
    sum.add(std::string_view(name));
    sum.add(std::string_view(text));
  }
  return sum.value();
}

std::int64_t check_rows(SqliteDatabase& database, std::optional<std::int64_t> design) {
  auto blocks = blocks_with_sums(database, design);
  auto rows = database.prepare("SELECT * FROM runs WHERE id >= ? ORDER BY id");
  bool has_row = false;
  bool begun = false;
  std::int64_t without = 0;
  while (blocks.step()) {
    const std::int64_t first = blocks.integer(0);
    const std::int64_t end = first + blocks.integer(1);
    if (!begun) {
      rows.bind(1, first);
      has_row = rows.step();
      begun = true;
    }
    const bool rows_between = has_row && rows.integer(0) < first;
    const std::int64_t sum = sum_of(blocks, rows, has_row, end);
    if (rows_between) {
      throw SqliteError(SQLITE_CORRUPT, "it has rows of designs that no block has");
    }
    if (blocks.is_null(1 + kBlockCounts)) {
      ++without;
    } else if (blocks.integer(1 + kBlockCounts) != sum) {
      throw SqliteError(SQLITE_CORRUPT,
                        fmt::format("the rows of the designs {} to {} are not those that were "
                                    "stored",
                                    first, end - 1));
    }
  }
  return without;
}

}  // namespace cognate::app
