#include "app/python/study.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/documents/json_values.hpp"
#include "app/documents/output_files.hpp"
#include "app/documents/version.hpp"
#include "app/export/toml_text.hpp"
#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/json.hpp"
#include "app/python/problem.hpp"
#include "app/python/watch.hpp"
#include "app/report/study_report.hpp"
#include "app/study/checksum.hpp"
#include "app/study/crew.hpp"
#include "app/study/database.hpp"
#include "app/study/evaluator.hpp"
#include "app/study/lock.hpp"
#include "app/study/metrics.hpp"
#include "app/study/read_columns.hpp"
#include "app/study/read_rows.hpp"
#include "app/study/run.hpp"
#include "app/study/sqlite.hpp"
#include "app/study/summary.hpp"
#include "problems/study/read.hpp"
#include "problems/toml/file_text.hpp"

namespace cognate::python {
namespace {

namespace fs = std::filesystem;
using problems::Study;

/// How many rows the report of a study shows, as `cognate sweep` has it.
constexpr std::size_t kReportedRows = 5000;

/// The text of a study: that of its file, or what was given as TOML.
std::string study_text(const Source& source, const py::dict& tables) {
  if (!source.file.empty() && tables.empty()) {
    auto text = problems::reading::text_of(source.file);
    if (!text) raise_faults(source, {{1, 1, text.error()}});
    return *std::move(text);
  }
  return app::toml_text(app::to_json(source.document));
}

/// A study and the files that it is kept in.
struct Opened {
  Study study;
  app::StudyOrigin origin;
  fs::path database;
};

Opened open_study(const py::object& given, const py::dict& tables, const std::string& stem,
                  const fs::path& folder, std::uint64_t seed) {
  const Source source = source_of(given, tables);
  const std::string text = study_text(source, tables);
  auto study = problems::parse_study(text, source.folder, app::study_metrics);
  if (!study) {
    // A text that was made here has other lines than what it was made of.
    Source made;
    made.file = tables.empty() ? source.file : "";
    if (!made.file.empty()) made.places = source.places;
    raise_faults(made, study.error());
  }
  const auto ready = app::prepare_folder(folder, {stem + ".study.db"});
  if (!ready) raise_fault("out", ready.error());
  return {*std::move(study),
          {.text = text, .version = std::string(app::version()), .seed = seed},
          app::final_target(folder / (stem + ".study.db"))};
}

/// Evaluates what is missing; the summary and the page.
std::pair<nlohmann::ordered_json, std::string> run_study(const Opened& opened,
                                                         const RunOptions& options, Watch& watch) {
  const auto begun = std::chrono::steady_clock::now();
  app::StudyDatabase database(opened.database, opened.study, opened.origin);
  const auto before = database.counts().evaluated;
  const auto total = problems::design_count(opened.study);
  app::WorkList work(database.missing(), app::block_size(opened.study));
  app::StudySummary summary{.seed = opened.origin.seed};
  {
    app::ThreadCrew crew(
        [&](const std::atomic<bool>* stopped) {
          return app::study_evaluator(opened.study, opened.origin.seed, stopped);
        },
        [&] { return work.next(); }, options.threads);
    summary.threads = crew.size();
    summary.end = app::run_study(
        database, crew,
        {.interrupted = watch.interrupted(), .time_limit = options.time_limit, .progress = [&] {
           const double done =
               double(database.counts().evaluated) / double(std::max<std::int64_t>(total, 1));
           watch.report(done, std::numeric_limits<double>::infinity());
         }});
  }
  summary.counts = database.counts();
  summary.evaluated = summary.counts.evaluated - before;
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  summary.best = app::best_rows(database.connection(), opened.study, app::kListedRows);
  auto document = app::study_document(opened.study, summary);
  const auto rows = app::report_rows(database.connection(), opened.study, kReportedRows);
  std::string page = app::study_report_html(document, opened.study, rows);
  return {std::move(document), std::move(page)};
}

py::tuple sweep(const py::object& given, const py::dict& tables, const std::string& stem,
                const std::string& out, const py::dict& run) {
  const RunOptions options =
      checked({run["seed"], run["threads"], run["time_limit"], run["progress"]});
  const Opened opened = open_study(given, tables, stem, out, options.seed);
  auto lock = app::StudyLock::take(app::lock_file(opened.database));
  if (!lock) raise_fault("", lock.error());
  std::pair<nlohmann::ordered_json, std::string> made;
  std::string fault;
  Watch watch;
  watch.run(run["progress"], [&] {
    try {
      made = run_study(opened, options, watch);
    } catch (const app::StudyFileError& error) {
      fault = error.what();
    } catch (const app::SqliteError& error) {
      fault = fmt::format("cannot read '{}': {}", opened.database.string(), error.what());
    }
  });
  if (!fault.empty()) raise_fault("", fault);
  return py::make_tuple(to_python(made.first), made.second, opened.database.string());
}

/// Numbers of a column, or its words where there is one.
class Column {
 public:
  void add(const problems::Cell& cell) {
    const auto* number = std::get_if<double>(&cell);
    const auto* word = std::get_if<std::string>(&cell);
    numbers_.push_back(number ? *number : std::numeric_limits<double>::quiet_NaN());
    if (word == nullptr) return;
    words_.resize(numbers_.size());
    words_.back() = *word;
    has_words_ = true;
  }

  py::object array() {
    if (!has_words_) return to_array(std::move(numbers_));
    words_.resize(numbers_.size());
    return py::cast(words_);
  }

 private:
  std::vector<double> numbers_;
  std::vector<std::string> words_;
  bool has_words_ = false;
};

/// The columns of the rows with ids from `first` on, `most` of them; "id" and "status" among them.
py::dict read_rows(const std::string& file, const py::object& from, const py::object& at_most,
                   const py::object& names_wanted) {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  const std::int64_t first = whole_of(from, "first", 0, kMost);
  const std::int64_t most = at_most.is_none() ? -1 : whole_of(at_most, "most", 0, kMost);
  std::vector<std::string> wanted;
  for (const py::handle name : names_wanted) wanted.push_back(text_of(name, "names"));
  std::vector<std::string> names{"id", "status"};
  std::vector<Column> columns;
  std::string fault;
  {
    const py::gil_scoped_release unlocked;
    try {
      auto database = app::study_rows(file, {.first = first, .most = most < 0 ? kMost : most});
      if (app::is_columns_file(file)) app::check_rows(database);
      auto known = app::stored_names(database, "variables");
      std::ranges::move(app::stored_names(database, "metrics"), std::back_inserter(known));
      for (const std::string& name : wanted.empty() ? known : wanted) {
        if (std::ranges::find(known, name) == known.end()) fault = name;
        names.push_back(name);
      }
      if (fault.empty()) {
        std::string list;
        for (const auto& name : names) list += (list.empty() ? "" : ", ") + app::sql_name(name);
        auto rows =
            database.prepare("SELECT " + list + " FROM runs WHERE id >= ?1 ORDER BY id LIMIT ?2");
        rows.bind(1, first);
        rows.bind(2, most);
        columns.resize(names.size());
        while (rows.step()) {
          for (std::size_t k = 0; k < names.size(); ++k) {
            columns[k].add(rows.cell(static_cast<int>(k)));
          }
        }
      }
    } catch (const std::exception& error) {
      fault = "\n" + std::string(error.what());
    }
  }
  if (fault.starts_with("\n")) {
    raise_fault("", fmt::format("cannot read '{}': {}", file, fault.substr(1)));
  }
  if (!fault.empty())
    raise_fault("names", fmt::format("have \"{}\", no column of the study", fault));
  py::dict all;
  for (std::size_t k = 0; k < names.size(); ++k) all[py::str(names[k])] = columns[k].array();
  return all;
}

}  // namespace

void bind_studies(py::module_& module) {
  module.def("sweep", &sweep);
  module.def("toml_text", [](const py::dict& tables) {
    return app::toml_text(app::to_json(source_of(tables).document));
  });
  module.def("read_rows", &read_rows);
}

}  // namespace cognate::python
