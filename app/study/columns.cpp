#include "app/study/columns.hpp"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <map>
#include <system_error>

#include "app/console/option_text.hpp"
#include "app/documents/module.hpp"
#include "app/study/checksum.hpp"
#include "app/study/metrics.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/study/names.hpp"
#include "synthesis/whole_file.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRowsAtOnce = 1U << 15U;
// Of a number as a word, "-2.2250738585072014e-308".
constexpr std::size_t kNumberBytes = 24;
// "no-solution"
constexpr std::size_t kStatusBytes = 11;

WriteColumns* writer() {
  static void* const symbol = module_function("cognate-columns.so", "cognate_write_columns_2");
  return reinterpret_cast<WriteColumns*>(symbol);
}

/// As readers of the table know it: "length" is the unit of the study's lengths, where it has one.
std::string unit_of(const std::string& column, const problems::Study& study) {
  constexpr std::string_view kLength = "length";
  auto unit = metric_unit(column);
  // "of the target", "N or N·m": of some problems the one, of others the other.
  if (unit.find(" or ") != std::string::npos || unit.find("target") != std::string::npos) return "";
  for (auto at = unit.find(kLength); at != std::string::npos; at = unit.find(kLength)) {
    if (!study.length_unit) return "";
    unit.replace(at, kLength.size(), problems::to_string(*study.length_unit));
  }
  return unit;
}

/// "SELECT a(x), a(y) FROM runs" for each of `names`; `form` has {} for the name.
SqliteStatement select_each(SqliteDatabase& database, const char* form,
                            const std::vector<std::string>& names) {
  std::string sql;
  for (const auto& name : names) {
    sql += (sql.empty() ? "SELECT " : ", ") + fmt::format(fmt::runtime(form), sql_name(name));
  }
  auto statement = database.prepare(sql + " FROM runs");
  statement.step();
  return statement;
}

/// The metrics that are words in some row: SQLite sorts these after all numbers.
std::vector<std::string> columns_of_words(SqliteDatabase& database,
                                          const std::vector<std::string>& metrics) {
  std::vector<std::string> words;
  if (metrics.empty()) return words;
  const auto greatest = select_each(database, "max({})", metrics);
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    if (greatest.is_text(static_cast<int>(i))) words.push_back(metrics[i]);
  }
  return words;
}

/// The longest word of each of `words`, in bytes; a number among them is a word, too. Where there
/// are numbers or empty words, it has kinds.
std::map<std::string, ColumnHead> word_heads(SqliteDatabase& database,
                                             const std::vector<std::string>& words) {
  std::map<std::string, ColumnHead> heads;
  if (words.empty()) return heads;
  const auto longest = select_each(database, "max(length(CAST({} AS BLOB)))", words);
  const auto least = select_each(database, "min({})", words);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const int column = static_cast<int>(i);
    const auto length = std::max<std::int64_t>(longest.integer(column), 1);
    auto& head = heads[words[i]];
    head.bytes = static_cast<std::size_t>(length);
    if (!least.is_text(column)) head.bytes = std::max(head.bytes, kNumberBytes);
    head.has_kinds = !least.is_text(column) || least.view(column).empty();
  }
  return heads;
}

std::vector<ColumnHead> column_heads(SqliteDatabase& database, const problems::Study& study) {
  auto words = word_heads(database, columns_of_words(database, study.metrics));
  std::vector<ColumnHead> heads;
  for (const auto& name : problems::study_columns(study)) {
    ColumnHead& head = heads.emplace_back(std::move(words[name]));
    head.name = name;
    head.unit = unit_of(name, study);
  }
  heads.push_back({.name = "status", .unit = "", .bytes = kStatusBytes});
  return heads;
}

ColumnsHead head_of(SqliteDatabase& database, const problems::Study& study) {
  ColumnsHead head{.columns = column_heads(database, study),
                   .rows = database.integer("SELECT count(*) FROM runs"),
                   .block_columns = {block_columns().begin(), block_columns().end()},
                   .blocks = database.integer("SELECT count(*) FROM blocks")};
  auto rows = database.prepare("SELECT name, value FROM study ORDER BY rowid");
  while (rows.step()) head.study.emplace_back(rows.text(0), rows.text(1));
  head.study_checksum = texts_checksum(head.study);
  if (study.objectives.size() < 2) return head;
  head.front.emplace();
  auto front = database.prepare("SELECT id FROM front ORDER BY id");
  while (front.step()) head.front->push_back(front.integer(0));
  return head;
}

void add_word(std::string& words, const SqliteStatement& row, int column, std::size_t bytes) {
  const auto end = words.size() + bytes;
  if (row.is_text(column)) {
    words.append(row.view(column));
  } else if (!row.is_null(column)) {
    words.append(fmt::format("{}", row.real(column)));
  }
  words.resize(end, '\0');
}

char kind_of(const SqliteStatement& row, int column) {
  return static_cast<char>(row.cell(column).index());
}

/// Rows of a study file, some at once.
class RowReader {
 public:
  RowReader(SqliteDatabase& database, const ColumnsHead& head)
      : head_(head), rows_(database.prepare("SELECT * FROM runs ORDER BY id")) {}

  bool next(ColumnRows& rows) {
    const auto width = head_.columns.size();
    rows.ids.clear();
    rows.numbers.resize(width);
    rows.words.resize(width);
    rows.kinds.resize(width);
    for (auto& kinds : rows.kinds) kinds.clear();
    for (auto& numbers : rows.numbers) numbers.clear();
    for (auto& words : rows.words) words.clear();
    while (rows.ids.size() < kRowsAtOnce && read_ < head_.rows && rows_.step()) add(rows);
    return !rows.ids.empty();
  }

  std::int64_t read() const { return read_; }

 private:
  void add(ColumnRows& rows) {
    rows.ids.push_back(rows_.integer(0));
    for (std::size_t i = 0; i < head_.columns.size(); ++i) {
      const int column = static_cast<int>(i) + 1;
      if (const auto bytes = head_.columns[i].bytes; bytes > 0) {
        add_word(rows.words[i], rows_, column, bytes);
        if (head_.columns[i].has_kinds) rows.kinds[i].push_back(kind_of(rows_, column));
      } else {
        rows.numbers[i].push_back(rows_.is_null(column) ? std::numeric_limits<double>::quiet_NaN()
                                                        : rows_.real(column));
      }
    }
    ++read_;
  }

  const ColumnsHead& head_;
  SqliteStatement rows_;
  std::int64_t read_ = 0;
};

/// Blocks of a study file, some at once.
class BlockReader {
 public:
  explicit BlockReader(SqliteDatabase& database)
      : blocks_(database.prepare("SELECT b.*, c.sum IS NOT NULL, ifnull(c.sum, 0) FROM blocks b "
                                 "LEFT JOIN checksums c ON c.first = b.first ORDER BY b.first")) {}

  bool next(std::vector<std::vector<std::int64_t>>& blocks) {
    blocks.assign(kBlockColumns, {});
    while (more_ && blocks.front().size() < kRowsAtOnce && (more_ = blocks_.step())) {
      for (std::size_t i = 0; i < kBlockColumns; ++i) {
        blocks[i].push_back(blocks_.integer(static_cast<int>(i)));
      }
    }
    return !blocks.front().empty();
  }

 private:
  SqliteStatement blocks_;
  bool more_ = true;  ///< a statement that is stepped at its end begins anew
};

}  // namespace

tl::expected<bool, std::string> parse_row_format(std::string_view text) {
  if (text == "hdf5") return true;
  if (text == "sqlite") return false;
  return refusal("--format", text, "hdf5, or sqlite, which is written in any case");
}

FileResult find_columns_module() {
  if (writer() != nullptr) return {};
  return tl::unexpected(
      std::string("--format: hdf5 needs HDF5, without which Cognate was built; install "
                  "libhdf5-dev and build again"));
}

FileResult write_columns(const fs::path& file, SqliteDatabase& database,
                         const problems::Study& study, const std::atomic<bool>& stopped,
                         const std::function<void(std::int64_t)>& progress) {
  const auto head = head_of(database, study);
  RowReader reader(database, head);
  BlockReader blocks(database);
  std::string fault;
  const int error = write_whole_file(file, [&](const fs::path& draft) {
    const int failed = writer()(
        draft, head,
        [&](ColumnRows& rows) {
          progress(reader.read());
          return !stopped && reader.next(rows);
        },
        [&](std::vector<std::vector<std::int64_t>>& some) { return !stopped && blocks.next(some); },
        fault);
    return stopped ? ECANCELED : failed;
  });
  if (error == ECANCELED)
    return tl::unexpected(fmt::format("'{}' was not written: interrupted", file.string()));
  if (error == 0) return {};
  return tl::unexpected(fmt::format("cannot write '{}': {}{}", file.string(),
                                    std::generic_category().message(error),
                                    error == EIO ? " (HDF5 says " + fault + ")" : ""));
}

}  // namespace cognate::app
