#include "problems/study/read_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "problems/study/read_base.hpp"
#include "problems/study/read_filters.hpp"
#include "problems/study/read_metrics.hpp"
#include "problems/study/read_variables.hpp"
#include "problems/task_document.hpp"
#include "problems/toml/nearest.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kMetrics = "metrics";
constexpr Count kNames{1, 200, "names"};

// Whether the file says that it is a study, which it may do by its `base` alone; a fault if not.
bool read_kind(TableReader& file) {
  if (!file.has(kKind)) return true;
  const auto kind = file.text(kKind);
  if (kind && *kind == kStudyKind) return true;
  if (kind) {
    file.fault(kKind, fmt::format("is {}; 'cognate sweep' runs a file of kind = \"study\", whose "
                                  "base may be of another kind",
                                  in_quotes(*kind)));
  }
  return false;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

void read_metrics(TableReader& output, const StudyNames& names, Study& study) {
  const auto metrics = output.texts(kMetrics, kNames);
  for (std::size_t i = 0; metrics && i < metrics->size(); ++i) {
    const std::string& name = (*metrics)[i];
    const auto refuse = [&](const std::string& what) {
      output.faults().add(output.where(kMetrics, i),
                          fmt::format("output.metrics has {}{}", in_quotes(name), what));
    };
    if (names.is_varied(name)) {
      refuse(", which varies; what varies has its column without being named");
    } else if (!names.find(name)) {
      refuse(", no metric of the base; " + names.hint(name));
    } else if (holds(study.metrics, name)) {
      refuse(" a second time; expected each metric once");
    } else if (const auto other = names.namesake(name)) {
      refuse(fmt::format(" beside {}; expected columns that differ in more than capitals",
                         in_quotes(*other)));
    } else {
      study.metrics.push_back(name);
    }
  }
}

void read_output(TableReader& output, const StudyNames& names, Study& study) {
  constexpr std::string_view kRows[] = {"passed", "all"};
  read_metrics(output, names, study);
  study.keep_all = output.choice_of("rows", kRows).value_or(0) == 1;
  output.finish();
}

// The names under `key`, one or a list of them.
std::vector<std::string> one_or_more(TableReader& table, std::string_view key) {
  if (table.has_array(key)) return table.texts(key, kNames).value_or(std::vector<std::string>{});
  const auto one = table.text(key);
  return one ? std::vector{*one} : std::vector<std::string>{};
}

void read_objectives(TableReader& table, std::string_view key, bool greatest,
                     const StudyNames& names, Study& study) {
  const auto wanted = one_or_more(table, key);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::string& name = wanted[i];
    const auto refuse = [&](const std::string& what) {
      table.faults().add(table.where(key, i),
                         fmt::format("{} has {}{}", table.name(key), in_quotes(name), what));
    };
    const auto kind = names.find(name);
    if (!kind) {
      refuse(", neither a metric of the base nor varied; " + names.hint(name));
    } else if (*kind == NameKind::word) {
      refuse(", which is a word; expected a metric that is a number");
    } else if (std::ranges::find(study.objectives, name, &StudyObjective::name) !=
               study.objectives.end()) {
      refuse(" a second time; expected each once, least or greatest");
    } else if (const auto other = names.namesake(name)) {
      refuse(fmt::format(" beside {}; expected columns that differ in more than capitals",
                         in_quotes(*other)));
    } else {
      study.objectives.push_back({name, greatest});
    }
  }
}

// Objectives that are not among the metrics become such.
void add_objectives_to_metrics(const StudyNames& names, Study& study) {
  for (const auto& objective : study.objectives) {
    if (names.is_varied(objective.name) || holds(study.metrics, objective.name)) continue;
    study.metrics.push_back(objective.name);
  }
}

void read_filter_table(const Table& document, const StudyNames& names, Study& study,
                       FaultList& faults) {
  const auto found = std::ranges::find(document, "filter", &Entry::key);
  if (found == document.end()) return;
  if (const auto* table = std::get_if<Table>(&found->node.value)) {
    study.filters = read_filters(*table, names, faults);
  } else {
    faults.add(found->node.where,
               fmt::format("filter is {}; expected a table [filter]", type_name(found->node)));
  }
}

}  // namespace

Study read_study(const Table& document, const std::filesystem::path& folder,
                 const MetricCatalogue& metrics, FaultList& faults) {
  Study study;
  TableReader file(document, faults);
  if (!read_kind(file)) return study;  // further faults depend on the kind
  study.title = file.text("title").value_or("");
  const auto base = read_base(file, folder, metrics, study);
  read_variables(file, base ? &*base : nullptr, study);
  const StudyNames names(base ? &*base : nullptr, study);
  file.know({"filter"});
  read_filter_table(document, names, study, faults);
  TableReader output = file.table("output");
  read_output(output, names, study);
  TableReader objective = file.table("objective");
  read_objectives(objective, "minimize", false, names, study);
  read_objectives(objective, "maximize", true, names, study);
  objective.finish();
  add_objectives_to_metrics(names, study);
  if (study.metrics.empty() && !output.contains(kMetrics) && base) {
    file.fault("output",
               "names no metrics; expected at least one, as [output] metrics = "
               "[\"time_ratio\"]");
  }
  file.finish();
  return study;
}

}  // namespace cognate::problems::reading
