/// @file The rows of a study from its columns in HDF5, NAME.study.h5, as its database has them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>

#include "app/study/columns_module.hpp"
#include "app/study/sqlite.hpp"

namespace cognate::app {

/// Rows by their ids: `most` from `first` on.
struct RowRange {
  std::int64_t first = 0;
  std::int64_t most = std::numeric_limits<std::int64_t>::max();
};

/// Whether `file` is to be read as columns: it begins as HDF5's files do, or is no database though
/// its name ends in ".h5".
bool is_columns_file(const std::filesystem::path& file);

/// A file of columns, of the format that is read here. Throws a StudyFileError that names the file
/// where it is none, or the program has no HDF5.
std::unique_ptr<ColumnsFile> open_columns_file(const std::filesystem::path& file);

/// The rows of the study file `file`, a database or columns, to be read by SQL. Of columns those of
/// `wanted`, and what else their blocks have, are in a database of their own, which goes with the
/// connection; its rows are as they are in the file, which `check_rows` looks at. Throws
/// SqliteError where a database cannot be opened, and a StudyFileError that names the file where
/// columns are damaged, of another format, or no columns of a study.
SqliteDatabase study_rows(const std::filesystem::path& file, const RowRange& wanted = {});

}  // namespace cognate::app
