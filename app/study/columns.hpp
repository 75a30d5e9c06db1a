/// @file The rows of a study as columns in HDF5, NAME.study.h5, for programs that read arrays.
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
#include "app/study/columns_module.hpp"
#include "app/study/sqlite.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

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
