#include "app/study/read_columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/documents/module.hpp"
#include "app/study/checksum.hpp"
#include "app/study/columns.hpp"
#include "app/study/database.hpp"
#include "app/study/read_rows.hpp"
#include "app/study/schema.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::int64_t kMostRowsAtOnce = 1 << 15;
constexpr std::int64_t kBytesAtOnce = 16 << 20;
constexpr std::string_view kSignature = "\x89HDF\r\n\x1A\n"sv;
constexpr std::string_view kDatabaseSignature = "SQLite format 3\0"sv;

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw StudyFileError(fmt::format("'{}' {}", file.string(), what));
}

[[noreturn]] void refuse_damaged(const fs::path& file, const std::string& what) {
  refuse(file, fmt::format("is damaged ({}); 'cognate sweep NAME.toml --format hdf5' beside the "
                           "database of the study writes it again",
                           what));
}

/// What of the file is read, once it is known to be no other.
template <class Value>
Value taken(const fs::path& file, ColumnsResult<Value> result) {
  if (!result) refuse(file, result.error());
  return *std::move(result);
}

OpenColumns* opener() {
  static void* const symbol = module_function("cognate-columns.so", "cognate_open_columns_2");
  return reinterpret_cast<OpenColumns*>(symbol);
}

/// Throws where the columns are not of the format that is read here.
void expect_format(const fs::path& file, ColumnsFile& columns) {
  const auto format = taken(file, columns.format());
  if (format == kColumnsFormat) return;
  const bool is_first = format.empty() && columns.text("study/format").has_value();
  if (format.starts_with("cognate-study-columns/") || is_first) {
    refuse(file, fmt::format("has the format {}, and this version of Cognate reads {} alone; "
                             "'cognate sweep NAME.toml --format hdf5' beside the database of the "
                             "study writes it again",
                             is_first ? "cognate-study-columns/1" : format, kColumnsFormat));
  }
  refuse(file,
         "has no columns of a study; expected NAME.study.h5 of 'cognate sweep --format "
         "hdf5', or NAME.study.db");
}

/// What the columns say about their study, and as much of it as the tables depend on.
struct StoredStudy {
  std::vector<std::pair<std::string, std::string>> identity;
  problems::Study study;
  std::int64_t designs = 0;

  const std::string& text(std::string_view name) const {
    return std::ranges::find(identity, name, [](const auto& row) { return row.first; })->second;
  }
};

void read_definition(StoredStudy& stored) {
  using nlohmann::json;
  for (const auto& key : json::parse(stored.text("variables"))) {
    stored.study.variables.push_back({.key = key.get<std::string>()});
  }
  stored.study.metrics = json::parse(stored.text("metrics")).get<std::vector<std::string>>();
  for (const auto& objective : json::parse(stored.text("objectives"))) {
    for (const auto& [way, name] : objective.items()) {
      stored.study.objectives.push_back({name.get<std::string>(), way == "maximize"});
    }
  }
  const auto& designs = stored.text("designs");
  std::from_chars(designs.data(), designs.data() + designs.size(), stored.designs);
}

StoredStudy stored_study(const fs::path& file, ColumnsFile& columns) {
  StoredStudy stored;
  for (const auto& name : study_identity_names()) {
    stored.identity.emplace_back(name, taken(file, columns.text("study/" + name)));
  }
  if (taken(file, columns.attribute("study", "checksum")) != texts_checksum(stored.identity)) {
    refuse_damaged(file, "its study is not that which was stored");
  }
  try {
    read_definition(stored);
  } catch (const nlohmann::json::exception&) {
    refuse_damaged(file, "it has no names of its columns");
  }
  return stored;
}

/// Rows one after the other, read some at once.
class RowStream {
 public:
  RowStream(const fs::path& file, ColumnsFile& columns, const problems::Study& study)
      : file_(file), columns_(columns), rows_(taken(file, columns.length("runs/id"))) {
    auto names = problems::study_columns(study);
    names.emplace_back("status");
    heads_ = taken(file, columns.open_columns(names, rows_));
    std::int64_t bytes = sizeof(std::int64_t);
    for (const auto& head : heads_) {
      bytes += static_cast<std::int64_t>(std::max(head.bytes, sizeof(double)));
    }
    at_once_ = std::clamp<std::int64_t>(kBytesAtOnce / bytes, 1, kMostRowsAtOnce);
  }

  std::int64_t rows() const { return rows_; }
  /// Which row is next.
  std::int64_t next() const { return from_ + static_cast<std::int64_t>(row_); }

  /// Leaves out rows. There are so many.
  void skip(std::int64_t count) {
    from_ = next() + count;
    row_ = 0;
    part_.ids.clear();
  }

  /// Goes on to a row, which there is.
  void advance() {
    if (row_ == part_.ids.size()) {
      from_ += static_cast<std::int64_t>(row_);
      row_ = 0;
      const auto read = columns_.read(from_, std::min(at_once_, rows_ - from_), part_);
      if (!read) refuse(file_, read.error());
    }
    at_ = row_++;
  }

  std::int64_t id() const { return part_.ids[at_]; }

  /// Binds the row's id and values from the first parameter on.
  void bind(SqliteStatement& insert) const {
    insert.bind(1, id());
    for (std::size_t i = 0; i < heads_.size(); ++i) bind_value(insert, i);
  }

 private:
  void bind_value(SqliteStatement& insert, std::size_t i) const {
    const int place = static_cast<int>(i) + 2;
    const auto bytes = heads_[i].bytes;
    if (bytes == 0) {
      const double number = part_.numbers[i][at_];
      if (std::isinf(number)) {
        refuse_damaged(file_, fmt::format("row {} has an infinite {}", id(), heads_[i].name));
      }
      return insert.bind(place, problems::Cell(number));
    }
    std::string_view word = std::string_view(part_.words[i]).substr(at_ * bytes, bytes);
    word = word.substr(0, word.find_last_not_of('\0') + 1);
    const int kind = heads_[i].has_kinds ? part_.kinds[i][at_] : word.empty() ? 0 : 2;
    if (kind == 0) return insert.bind(place, problems::Cell());
    if (kind == 1) return insert.bind(place, number_of(word, i));
    // Not null where it has no letters.
    insert.bind(place, word.empty() ? ""sv : word);
  }

  /// A number that stands as a word among words.
  double number_of(std::string_view word, std::size_t i) const {
    double number = NAN;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool is_whole = read.ec == std::errc{} && read.ptr == word.data() + word.size();
    if (!is_whole || !std::isfinite(number)) {
      refuse_damaged(file_, fmt::format("row {} has no number in {}", id(), heads_[i].name));
    }
    return number;
  }

  const fs::path& file_;
  ColumnsFile& columns_;
  std::int64_t rows_;
  std::vector<ColumnHead> heads_;
  std::int64_t at_once_ = 1;
  std::int64_t from_ = 0;  ///< the number of the first row of `part_`
  ColumnRows part_;
  std::size_t row_ = 0;  ///< of `part_`, which is next
  std::size_t at_ = 0;   ///< of `part_`, which was last
};

/// Puts the columns of a file into an empty database.
class ColumnsLoader {
 public:
  ColumnsLoader(const fs::path& file, SqliteDatabase& database)
      : file_(file),
        columns_(open_columns_file(file)),
        stored_(stored_study(file, *columns_)),
        rows_(file, *columns_, stored_.study),
        database_(database) {}

  void load(const RowRange& wanted) {
    database_.execute("PRAGMA journal_mode = OFF");
    database_.execute("BEGIN");
    create_tables();
    const bool all = load_blocks(wanted);
    if (all) load_front();
    database_.execute("COMMIT");
  }

 private:
  /// A block by the columns of `block_columns()`.
  using Block = std::array<std::int64_t, kBlockColumns>;

  void create_tables() {
    database_.execute(fmt::format("PRAGMA application_id = {}", kStudyApplicationId));
    for (const auto& statement : study_schema(stored_.study)) database_.execute(statement);
    database_.execute(kChecksumTable);
    auto insert = database_.prepare("INSERT INTO study VALUES (?, ?)");
    for (const auto& [name, value] : stored_.identity) {
      insert.bind(1, std::string_view(name));
      insert.bind(2, std::string_view(value));
      insert.run();
    }
    std::string places = "?, ?";
    for (std::size_t i = 0; i < problems::study_columns(stored_.study).size(); ++i) places += ", ?";
    insert_row_ = database_.prepare("INSERT INTO runs VALUES (" + places + ")");
    insert_block_ = database_.prepare("INSERT INTO blocks VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    insert_sum_ = database_.prepare("INSERT INTO checksums VALUES (?, ?)");
  }

  /// Whether these were all blocks of the file.
  bool load_blocks(const RowRange& wanted) {
    const auto length = taken(file_, columns_->length("blocks/first"));
    std::int64_t next_design = 0, found = 0;
    bool all = true;
    std::array<std::vector<std::int64_t>, kBlockColumns> some;
    for (std::int64_t from = 0; from < length; from += kMostRowsAtOnce) {
      const auto count = std::min(kMostRowsAtOnce, length - from);
      for (std::size_t i = 0; i < kBlockColumns; ++i) some[i] = block_part(i, length, from, count);
      for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        Block block;
        for (std::size_t i = 0; i < kBlockColumns; ++i) block[i] = some[i][k];
        next_design = checked_end(block, next_design);
        if (next_design <= wanted.first) {
          rows_.skip(block[2]);
          all = false;
        } else {
          found += load_block(block, wanted.first);
        }
        if (found >= wanted.most) return false;
      }
    }
    if (rows_.next() != rows_.rows()) refuse_damaged(file_, "its rows are not those of its blocks");
    return all;
  }

  std::vector<std::int64_t> block_part(std::size_t column, std::int64_t length, std::int64_t from,
                                       std::int64_t count) {
    const auto name = fmt::format("blocks/{}", block_columns()[column]);
    if (from == 0 && taken(file_, columns_->length(name)) != length) {
      refuse(file_, fmt::format("has blocks of different lengths in {} and blocks/first", name));
    }
    return taken(file_, columns_->integers(name, from, count));
  }

  /// The design after those of a block, which begins at `next_design` or later.
  std::int64_t checked_end(const Block& block, std::int64_t next_design) const {
    const auto [first, count, kept] = std::tuple(block[0], block[1], block[2]);
    if (count < 1 || count > stored_.designs || first < next_design ||
        first > stored_.designs - count) {
      refuse_damaged(file_, "its blocks overlap, or are of no design");
    }
    if (kept < 0 || kept > count || kept > rows_.rows() - rows_.next()) {
      refuse_damaged(file_, "its rows are not those of its blocks");
    }
    return first + count;
  }

  /// How many of its rows have an id of `first_wanted` or more.
  std::int64_t load_block(const Block& block, std::int64_t first_wanted) {
    for (std::size_t i = 0; i <= kBlockCounts; ++i) {
      insert_block_->bind(static_cast<int>(i) + 1, block[i]);
    }
    insert_block_->run();
    if (block[kBlockCounts + 1] != 0) {
      insert_sum_->bind(1, block[0]);
      insert_sum_->bind(2, block[kBlockCounts + 2]);
      insert_sum_->run();
    }
    std::int64_t last = block[0] - 1, found = 0;
    for (std::int64_t k = 0; k < block[2]; ++k) {
      rows_.advance();
      if (rows_.id() <= last || rows_.id() >= block[0] + block[1]) {
        refuse_damaged(file_, "its rows are not those of its blocks");
      }
      last = rows_.id();
      found += last >= first_wanted ? 1 : 0;
      rows_.bind(*insert_row_);
      insert_row_->run();
    }
    return found;
  }

  /// The front of the rows, which with several objectives is that of the file.
  void load_front() {
    const auto& study = stored_.study;
    if (study.objectives.empty()) return;
    std::vector<std::int64_t> ids;
    const auto front = front_of_rows(database_, objective_columns(study));
    for (const auto& point : front.points()) ids.push_back(point.id);
    std::ranges::sort(ids);
    if (study.objectives.size() > 1) {
      const auto length = taken(file_, columns_->length("front"));
      const bool fits = length == static_cast<std::int64_t>(ids.size());
      if (!fits || taken(file_, columns_->integers("front", 0, length)) != ids) {
        refuse_damaged(file_, "its front is not that of its rows");
      }
    }
    auto insert = database_.prepare("INSERT INTO front VALUES (?)");
    for (const auto id : ids) {
      insert.bind(1, id);
      insert.run();
    }
  }

  const fs::path& file_;
  std::unique_ptr<ColumnsFile> columns_;
  StoredStudy stored_;
  RowStream rows_;
  SqliteDatabase& database_;
  std::optional<SqliteStatement> insert_row_, insert_block_, insert_sum_;
};

}  // namespace

bool is_columns_file(const fs::path& file) {
  const bool is_named_so = file.extension() == ".h5";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return is_named_so;
  std::string begin(kDatabaseSignature.size(), ' ');
  std::ifstream(file, std::ios::binary).read(begin.data(), std::streamsize(begin.size()));
  return begin.starts_with(kSignature) || (is_named_so && begin != kDatabaseSignature);
}

std::unique_ptr<ColumnsFile> open_columns_file(const fs::path& file) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) refuse(file, "is not there; expected NAME.study.h5 or NAME.study.db");
  // HDF5 would wait for the other end of a pipe.
  if (!fs::is_regular_file(status)) refuse(file, "is no regular file; expected NAME.study.h5");
  if (!std::ifstream(file)) refuse(file, "cannot be read; expected a file that may be read");
  if (opener() == nullptr) {
    refuse(file,
           "cannot be read: Cognate was built without HDF5; install libhdf5-dev and build "
           "again, or give NAME.study.db");
  }
  ColumnsResult<std::unique_ptr<ColumnsFile>> opened;
  opener()(file, opened);
  auto columns = taken(file, std::move(opened));
  expect_format(file, *columns);
  return columns;
}

SqliteDatabase study_rows(const fs::path& file, const RowRange& wanted) {
  if (!is_columns_file(file)) return {file, SqliteDatabase::Access::read};
  try {
    auto database = SqliteDatabase::temporary();
    ColumnsLoader(file, database).load(wanted);
    return database;
  } catch (const SqliteError& failed) {
    refuse(file, fmt::format("cannot be read: {} (in SQLite's temporary file)", failed.what()));
  }
}

}  // namespace cognate::app
