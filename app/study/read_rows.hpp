/// @file Rows of a study file.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/study/front.hpp"
#include "app/study/rows.hpp"
#include "app/study/sqlite.hpp"
#include "problems/study/names.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

/// How many of the best rows are printed and stand in the summary.
inline constexpr std::size_t kListedRows = 10;

/// Adds to `rows`, StudyRows or a block of a study, the row of `width` cells on which `statement`,
/// a SELECT * FROM runs, stands. Throws SqliteError where its status is none.
template <class Rows>
void add_row(Rows& rows, const SqliteStatement& statement, int width) {
  rows.ids.push_back(statement.integer(0));
  for (int i = 1; i <= width; ++i) rows.cells.push_back(statement.cell(i));
  const auto status = problems::from_string<problems::RunStatus>(statement.text(width + 1));
  if (!status) throw SqliteError(SQLITE_CORRUPT, "a row has an unknown status");
  rows.statuses.push_back(*status);
}

/// Where the objectives of a study stand among its columns: the column, and −1 for the greatest.
using ObjectiveColumns = std::vector<std::pair<std::size_t, double>>;
ObjectiveColumns objective_columns(const problems::Study& study);

/// The Pareto front of the rows in `database`, which the table `front` should have.
StudyFront front_of_rows(SqliteDatabase& database, const ObjectiveColumns& objectives);

/// The best rows, at most `most` of them, best first: by the objective, or of the front of several
/// an even selection in the order of the first; none without objective. All throw SqliteError.
StudyRows best_rows(SqliteDatabase& database, const problems::Study& study, std::size_t most);

/// What a report shows: all rows, or the best and others spread evenly over the designs, at most
/// `most` together; by ascending id.
StudyRows report_rows(SqliteDatabase& database, const problems::Study& study, std::size_t most);

/// The names in the row `name` ("variables", "metrics") of the table `study`. Throws
/// nlohmann::json::exception where it holds no list of names.
std::vector<std::string> stored_names(SqliteDatabase& database, std::string_view name);

/// The row of design `id`; empty where that was not kept or there is none.
std::optional<StudyRows> row_of(SqliteDatabase& database, const problems::Study& study,
                                std::int64_t id);

}  // namespace cognate::app
