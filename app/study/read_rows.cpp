#include "app/study/read_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "problems/study/names.hpp"

namespace cognate::app {
namespace {

using Ids = std::vector<std::int64_t>;

Ids ids_of(SqliteDatabase& database, const std::string& sql) {
  Ids ids;
  auto rows = database.prepare(sql);
  while (rows.step()) ids.push_back(rows.integer(0));
  return ids;
}

/// At most `most` of `ids`, the first and the last among them, evenly.
Ids spread(const Ids& ids, std::size_t most) {
  if (ids.size() <= most) return ids;
  Ids chosen;
  for (std::size_t i = 0; i < most; ++i) {
    chosen.push_back(ids[most == 1 ? 0 : i * (ids.size() - 1) / (most - 1)]);
  }
  return chosen;
}

Ids best_ids(SqliteDatabase& database, const problems::Study& study, std::size_t most) {
  if (study.objectives.empty()) return {};
  if (study.objectives.size() == 1) {
    return ids_of(database, fmt::format("SELECT id FROM best LIMIT {}", most));
  }
  return spread(ids_of(database, "SELECT id FROM best"), most);
}

/// Adds to `ids` rows at even distances over all designs until there are `most`.
void add_others(SqliteDatabase& database, std::set<std::int64_t>& ids, std::size_t most) {
  const auto last = database.integer("SELECT max(id) FROM runs");
  auto next = database.prepare("SELECT id FROM runs WHERE id >= ? ORDER BY id LIMIT 1");
  const auto places = static_cast<std::int64_t>(most - ids.size());
  for (std::int64_t i = 0; i < places; ++i) {
    // last · i / places without overflow
    const auto from = last / places * i + last % places * i / places;
    next.bind(1, from);
    if (next.step()) ids.insert(next.integer(0));
    next.reset();
  }
}

/// The rows of `ids` in their order.
template <class Numbers>
StudyRows rows_of(SqliteDatabase& database, const problems::Study& study, const Numbers& ids) {
  StudyRows rows{.columns = problems::study_columns(study),
                 .total = database.integer("SELECT sum(kept) FROM blocks")};
  auto row = database.prepare("SELECT * FROM runs WHERE id = ?");
  for (const auto id : ids) {
    row.bind(1, id);
    if (row.step()) add_row(rows, row, static_cast<int>(rows.columns.size()));
    row.reset();
  }
  return rows;
}

}  // namespace

ObjectiveColumns objective_columns(const problems::Study& study) {
  const auto columns = problems::study_columns(study);
  ObjectiveColumns found;
  for (const auto& objective : study.objectives) {
    const auto column = std::ranges::find(columns, objective.name) - columns.begin();
    found.emplace_back(static_cast<std::size_t>(column), objective.greatest ? -1.0 : 1.0);
  }
  return found;
}

StudyFront front_of_rows(SqliteDatabase& database, const ObjectiveColumns& objectives) {
  StudyFront front;
  auto rows = database.prepare("SELECT * FROM runs WHERE status = 'solved'");
  std::vector<std::int64_t> left;
  StudyFront::Point point{.objectives = std::vector<double>(objectives.size())};
  while (rows.step()) {
    bool has_all = true;
    for (std::size_t i = 0; i < objectives.size() && has_all; ++i) {
      const auto& [column, sign] = objectives[i];
      const int place = static_cast<int>(column) + 1;
      has_all = !rows.is_null(place);
      if (has_all) point.objectives[i] = sign * rows.real(place);
    }
    point.id = rows.integer(0);
    if (has_all) front.add(point, left);
  }
  return front;
}

StudyRows best_rows(SqliteDatabase& database, const problems::Study& study, std::size_t most) {
  auto rows = rows_of(database, study, best_ids(database, study, most));
  rows.best.assign(rows.ids.size(), true);
  return rows;
}

StudyRows report_rows(SqliteDatabase& database, const problems::Study& study, std::size_t most) {
  const auto total = static_cast<std::size_t>(database.integer("SELECT sum(kept) FROM blocks"));
  auto best = best_ids(database, study, most / 2);
  std::set<std::int64_t> ids(best.begin(), best.end());
  if (total <= most) {
    const auto all = ids_of(database, "SELECT id FROM runs");
    ids.insert(all.begin(), all.end());
  } else {
    add_others(database, ids, most);
  }
  if (study.objectives.size() > 1) {
    best = ids_of(database, "SELECT id FROM front");
  } else if (best.size() > kListedRows) {
    best.resize(kListedRows);
  }
  std::ranges::sort(best);
  auto rows = rows_of(database, study, ids);
  for (const auto id : rows.ids) rows.best.push_back(std::ranges::binary_search(best, id));
  return rows;
}

std::vector<std::string> stored_names(SqliteDatabase& database, std::string_view name) {
  const auto text = database.text(fmt::format("SELECT value FROM study WHERE name = '{}'", name));
  return nlohmann::json::parse(text).get<std::vector<std::string>>();
}

std::optional<StudyRows> row_of(SqliteDatabase& database, const problems::Study& study,
                                std::int64_t id) {
  auto rows = rows_of(database, study, Ids{id});
  if (rows.ids.empty()) return std::nullopt;
  rows.best = {false};
  return rows;
}

}  // namespace cognate::app
