/// @file What the program and its module of HDF5 say to one another: only the module knows HDF5.
///
/// NAME.study.h5, attribute `format` "cognate-study-columns/2", has the groups
///
/// - `runs`: a dataset for each column by its name, in the order of the table, all of one length,
///   by ascending `id`: `id` of 64-bit integers; numbers of doubles, NaN where a design has none;
///   words and `status` of fixed length in UTF-8, filled up with zeros. Attribute `unit`.
/// - `kinds`: for columns of words in which numbers or empty words are, too, by the same name a
///   byte for each row: 0 nothing, 1 a number, written as a word, 2 a word.
/// - `blocks`: the table `blocks` by columns of 64-bit integers, and `has_checksum`, `checksum`.
/// - `study`: the rows of the table `study`, each a text; attribute `checksum` over all of them.
///
/// and the dataset `front`: the ids on the Pareto front, with several objectives.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace cognate::app {

inline constexpr const char* kColumnsFormat = "cognate-study-columns/2";

/// A column of numbers, or of words where these take some bytes.
struct ColumnHead {
  std::string name, unit;
  std::size_t bytes = 0;   ///< of each word
  bool has_kinds = false;  ///< of words, with a kind for each row
};

struct ColumnsHead {
  std::vector<std::pair<std::string, std::string>> study;
  std::int64_t study_checksum = 0;
  std::optional<std::vector<std::int64_t>> front;
  std::vector<ColumnHead> columns;  ///< without `id`
  std::int64_t rows = 0;
  std::vector<std::string> block_columns;
  std::int64_t blocks = 0;
};

/// Some rows, column by column. Of each column one of `numbers` and `words` is empty.
struct ColumnRows {
  std::vector<std::int64_t> ids;
  std::vector<std::vector<double>> numbers;
  std::vector<std::string> words;  ///< row by row, each as long as its column says
  std::vector<std::string> kinds;  ///< a byte for each row; empty of columns without
};

/// Fills in the next rows; false where there are none left, or no more are wanted.
using NextColumnRows = std::function<bool(ColumnRows& rows)>;

/// The same of blocks, a list for each of their columns.
using NextBlocks = std::function<bool(std::vector<std::vector<std::int64_t>>& blocks)>;

/// `cognate_write_columns_2`, whose name counts the interfaces of the module, so that a program
/// finds its own alone: writes the columns of `head.rows` rows to `file`, which is there; 0, or the
/// errno of what failed with what HDF5 says of it. What `next` throws goes through.
using WriteColumns = int(const std::filesystem::path& file, const ColumnsHead& head,
                         const NextColumnRows& next, const NextBlocks& next_blocks,
                         std::string& fault);

/// What was read, or what is wrong, in words that go on after the file's name.
template <class Value>
using ColumnsResult = tl::expected<Value, std::string>;

/// A file of columns that is open to be read; nothing of it is believed. Throws nothing.
class ColumnsFile {
 public:
  virtual ~ColumnsFile() = default;

  /// The attribute `format`; empty where there is none.
  virtual ColumnsResult<std::string> format() = 0;
  /// The text in the dataset `name`.
  virtual ColumnsResult<std::string> text(const std::string& name) = 0;
  /// The attribute `name`, a whole number, of a group.
  virtual ColumnsResult<std::int64_t> attribute(const std::string& group,
                                                const std::string& name) = 0;
  /// How many whole numbers the dataset `name` holds.
  virtual ColumnsResult<std::int64_t> length(const std::string& name) = 0;
  virtual ColumnsResult<std::vector<std::int64_t>> integers(const std::string& name,
                                                            std::int64_t from,
                                                            std::int64_t count) = 0;
  /// Opens the columns `names` of `runs`, whose rows `read` gives then. All, and `id`, must have
  /// `rows` rows.
  virtual ColumnsResult<std::vector<ColumnHead>> open_columns(const std::vector<std::string>& names,
                                                              std::int64_t rows) = 0;
  virtual ColumnsResult<void> read(std::int64_t from, std::int64_t count, ColumnRows& rows) = 0;
};

/// `cognate_open_columns_2`: opens `file` to be read.
using OpenColumns = void(const std::filesystem::path& file,
                         ColumnsResult<std::unique_ptr<ColumnsFile>>& opened);

}  // namespace cognate::app
