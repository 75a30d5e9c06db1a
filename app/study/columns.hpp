/// @file The rows of a study as columns in HDF5, NAME.study.h5, for programs that read arrays.
///
/// Group `runs`: a dataset for each column by its name, in the order of the table, all of one
/// length, by ascending `id`: `id` of 64-bit integers; numbers of doubles, NaN where a design has
/// none; words and `status` of fixed length in UTF-8, filled up with zeros. Attribute `unit` of a
/// column. Group `study`: the rows of the table `study`. Dataset `front`: the ids on the Pareto
/// front, with several objectives.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "app/documents/output_files.hpp"
#include "app/study/sqlite.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

/// A column of numbers, or of words where these take some bytes.
struct ColumnHead {
  std::string name, unit;
  std::size_t bytes = 0;  ///< of each word
};

struct ColumnsHead {
  std::vector<std::pair<std::string, std::string>> study;
  std::optional<std::vector<std::int64_t>> front;
  std::vector<ColumnHead> columns;  ///< without `id`
  std::int64_t rows = 0;
};

/// Some rows, column by column. Of each column one of `numbers` and `words` is empty.
struct ColumnRows {
  std::vector<std::int64_t> ids;
  std::vector<std::vector<double>> numbers;
  std::vector<std::string> words;  ///< row by row, each as long as its column says
};

/// Fills in the next rows; false where there are none left, or no more are wanted.
using NextColumnRows = std::function<bool(ColumnRows& rows)>;

/// Writes the columns of `head.rows` rows to `file`, which is there; 0, or the errno of what failed
/// with what HDF5 says of it. What `next` throws goes through.
using WriteColumns = int(const std::filesystem::path& file, const ColumnsHead& head,
                         const NextColumnRows& next, std::string& fault);

/// The word of `--format` of a study: whether its rows are written as columns, too.
tl::expected<bool, std::string> parse_row_format(std::string_view text);

/// Whether the program has HDF5, and what helps where it has not.
FileResult find_columns_module();

/// Writes the rows kept in `database` to `file`, whole or not at all; `progress` is called with
/// how many are written. Nothing is written once `stopped`. Throws SqliteError.
FileResult write_columns(const std::filesystem::path& file, SqliteDatabase& database,
                         const problems::Study& study, const std::atomic<bool>& stopped,
                         const std::function<void(std::int64_t)>& progress);

}  // namespace cognate::app
