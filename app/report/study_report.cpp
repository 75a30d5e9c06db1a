#include "app/report/study_report.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/report/filled_page.hpp"
#include "app/report/page.hpp"
#include "problems/read.hpp"
#include "problems/study/design_text.hpp"
#include "problems/study/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

ordered_json place(const Vec2d& point) {
  return {point.x, point.y};
}

ordered_json dimensions(const FourBar& linkage) {
  ordered_json mechanism = {{"fixed_pivots", {place(linkage.pivot_a), place(linkage.pivot_d)}},
                            {"crank", linkage.crank},
                            {"coupler", linkage.coupler},
                            {"rocker", linkage.rocker},
                            {"assembly", linkage.assembly == Assembly::open ? "open" : "crossed"}};
  if (linkage.coupler_point) mechanism["coupler_point"] = place(*linkage.coupler_point);
  return mechanism;
}

/// The number of `file` at `path`, or null.
ordered_json* number_at(ordered_json& file, const problems::KeyPath& path) {
  ordered_json* at = &file;
  for (const auto& step : path) {
    const auto* key = std::get_if<std::string>(&step);
    const auto* index = std::get_if<std::size_t>(&step);
    if (key && at->is_object() && at->contains(*key)) {
      at = &(*at)[*key];
    } else if (index && at->is_array() && *index < at->size()) {
      at = &(*at)[*index];
    } else {
      return nullptr;
    }
  }
  return at->is_number() ? at : nullptr;
}

using nlohmann::ordered_json;
using problems::Cell;
using problems::Study;

/// What a page holds that is to open at once.
constexpr std::size_t kStudyRows = 5'000;
constexpr std::size_t kStudyCells = 80'000;
constexpr std::size_t kBaseText = 200'000;
/// A column of at most this many different numbers is written as these and an index for each row.
constexpr std::size_t kLevels = 64;
constexpr int kMetricDigits = 9;

double rounded(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific,
                                 kMetricDigits - 1);
  std::from_chars(text, end.ptr, value);
  return value;
}

ordered_json number_or_null(const Cell& cell, bool exact) {
  const double* value = std::get_if<double>(&cell);
  if (!value || !std::isfinite(*value)) return nullptr;
  return exact ? *value : rounded(*value);
}

/// A number among words.
ordered_json word_or_null(const Cell& cell) {
  if (const auto* word = std::get_if<std::string>(&cell)) return *word;
  const ordered_json value = number_or_null(cell, false);
  return value.is_null() ? value : ordered_json(value.dump());
}

/// `values` as the different ones among them, ascending, and an index for each.
ordered_json by_levels(const std::vector<ordered_json>& values) {
  std::map<ordered_json, int> places;
  for (const ordered_json& value : values) {
    if (!value.is_null()) places.emplace(value, 0);
  }
  ordered_json levels = ordered_json::array(), index = ordered_json::array();
  for (auto& [value, place] : places) {
    place = static_cast<int>(levels.size());
    levels.push_back(value);
  }
  for (const ordered_json& value : values) {
    index.push_back(value.is_null() ? -1 : places.at(value));
  }
  return {{"levels", levels}, {"index", index}};
}

bool are_few(const std::vector<ordered_json>& values) {
  std::set<ordered_json> different;
  for (const ordered_json& value : values) {
    if (!value.is_null()) different.insert(value);
    if (different.size() > kLevels) return false;
  }
  return 2 * different.size() < values.size();
}

class Columns {
 public:
  Columns(const Study& study, const StudyRows& rows, const std::vector<std::size_t>& drawn)
      : study_(study), rows_(rows), drawn_(drawn) {}

  ordered_json all() const {
    ordered_json columns = ordered_json::array();
    for (std::size_t i = 0; i < rows_.columns.size(); ++i) columns.push_back(column(i));
    return columns;
  }

 private:
  const Cell& cell(std::size_t row, std::size_t column) const {
    return rows_.cells[row * rows_.columns.size() + column];
  }

  ordered_json column(std::size_t index) const {
    const bool varied = index < study_.variables.size();
    ordered_json column = {{"name", rows_.columns[index]},
                           {"role", varied ? "variable" : "metric"}};
    if (varied) describe(study_.variables[index], column);
    for (const auto& objective : study_.objectives) {
      if (objective.name == rows_.columns[index]) {
        column["wanted"] = objective.greatest ? "greatest" : "least";
      }
    }
    column.update(values(index, varied));
    return column;
  }

  static void describe(const problems::StudyVariable& variable, ordered_json& column) {
    if (variable.logarithmic) column["log"] = true;
    if (variable.range) column["range"] = {variable.range->min, variable.range->max};
    if (!variable.values.empty() && variable.values.size() <= kStudyRows) {
      column["grid"] = variable.values;
    }
  }

  ordered_json values(std::size_t index, bool exact) const {
    const bool has_words = std::ranges::any_of(drawn_, [&](std::size_t row) {
      return std::holds_alternative<std::string>(cell(row, index));
    });
    std::vector<ordered_json> values;
    values.reserve(drawn_.size());
    for (const std::size_t row : drawn_) {
      values.push_back(has_words ? word_or_null(cell(row, index))
                                 : number_or_null(cell(row, index), exact));
    }
    if (has_words || are_few(values)) return by_levels(values);
    return {{"values", values}};
  }

  const Study& study_;
  const StudyRows& rows_;
  const std::vector<std::size_t>& drawn_;
};

/// What the study asked, as far as its columns do not say it.
ordered_json questions(const Study& study) {
  ordered_json filters = ordered_json::array();
  for (const auto& filter : study.filters) {
    filters.push_back({{"name", filter.name},
                       {"min", number_or_null(filter.min, true)},
                       {"max", number_or_null(filter.max, true)},
                       {"words", filter.words}});
  }
  return {{"title", study.title},
          {"base", study.base},
          {"sampling", problems::to_string(study.sampling)},
          {"samples", study.samples},
          {"filters", filters}};
}

ordered_json base_pieces(const Study& study) {
  const problems::GappedText base = problems::gapped_base(study);
  return {{"pieces", base.pieces}, {"variables", base.variable}};
}

using nlohmann::ordered_json;

/// `document` without what would make the page too large: the best rows, which are among those
/// drawn, and long lists of values.
ordered_json without_large_lists(const ordered_json& document) {
  ordered_json kept = document;
  for (const char* member : {"best", "study", "notes"}) erase_large(kept, member);
  return kept;
}

}  // namespace

std::optional<ordered_json> study_linkage(const problems::Study& study) {
  const auto base = problems::parse_task<problems::AnalysisProblem>(study.base_text);
  if (!base || !base->mechanism.four_bar()) return std::nullopt;
  ordered_json file = {{"mechanism", dimensions(*base->mechanism.four_bar())}};
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    if (ordered_json* number = number_at(file, study.variables[i].path)) {
      *number = {{"variable", i}};
    }
  }
  ordered_json& linkage = file["mechanism"];
  linkage["start"] = base->drive.start;
  return linkage;
}

std::vector<std::size_t> drawn_study_rows(const StudyRows& rows) {
  const std::size_t count = rows.ids.size();
  const std::size_t room =
      std::min(kStudyRows, kStudyCells / std::max<std::size_t>(1, rows.columns.size()));
  std::vector<std::size_t> best, others;
  for (std::size_t i = 0; i < count; ++i) (rows.best[i] ? best : others).push_back(i);
  const auto thin = [](std::vector<std::size_t>& list, std::size_t wanted) {
    if (list.size() <= wanted) return;
    const std::size_t size = list.size();
    for (std::size_t i = 0; i < wanted; ++i) list[i] = list[i * size / wanted];
    list.resize(wanted);
  };
  thin(best, room);
  thin(others, room - best.size());
  std::vector<std::size_t> drawn;
  std::ranges::merge(best, others, std::back_inserter(drawn));
  return drawn;
}

ordered_json study_report_data(const Study& study, const StudyRows& rows) {
  const std::vector<std::size_t> drawn = drawn_study_rows(rows);
  ordered_json ids = ordered_json::array(), best = ordered_json::array();
  std::vector<ordered_json> statuses;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    ids.push_back(rows.ids[drawn[i]]);
    statuses.emplace_back(problems::to_string(rows.statuses[drawn[i]]));
    if (rows.best[drawn[i]]) best.push_back(i);
  }
  ordered_json data = {{"columns", Columns(study, rows, drawn).all()},
                       {"ids", ids},
                       {"statuses", by_levels(statuses)},
                       {"best", best},
                       {"total", rows.total},
                       {"study", questions(study)}};
  if (study.base_text.size() <= kBaseText) data["base"] = base_pieces(study);
  if (const auto linkage = study_linkage(study)) data["linkage"] = *linkage;
  return data;
}

std::string study_report_html(const ordered_json& document, const problems::Study& study,
                              const StudyRows& rows, std::string_view database) {
  ordered_json data = study_report_data(study, rows);
  if (!database.empty()) data["database"] = database;
  data["result"] = without_large_lists(document);
  return filled_page(study_page(), data, length_word(study.length_unit));
}

}  // namespace cognate::app
