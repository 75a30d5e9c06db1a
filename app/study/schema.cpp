#include "app/study/schema.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/console/messages.hpp"
#include "app/study/database.hpp"
#include "app/study/sqlite.hpp"

namespace cognate::app {
namespace {

using Identity = std::vector<std::pair<std::string, std::string>>;

std::string value_of(const Identity& identity, std::string_view name) {
  const auto found = std::ranges::find(identity, name, [](const auto& row) { return row.first; });
  return found != identity.end() ? found->second : "";
}

/// The number, from 1, of the first line in which two texts differ.
std::size_t differing_line(const std::string& a, const std::string& b) {
  const auto at = std::ranges::mismatch(a, b).in1;
  return 1 + static_cast<std::size_t>(std::count(a.begin(), at, '\n'));
}

/// The rows of the view `best`: by the objective, on the front of several, or all that are solved.
std::string best_of(const problems::Study& study) {
  const auto& objectives = study.objectives;
  if (objectives.empty()) return "SELECT * FROM runs WHERE status = 'solved' ORDER BY id";
  const auto name = sql_name(objectives.front().name);
  const auto order =
      fmt::format("ORDER BY {} {}, id", name, objectives[0].greatest ? "DESC" : "ASC");
  if (objectives.size() == 1) {
    return fmt::format("SELECT * FROM runs WHERE status = 'solved' AND {} IS NOT NULL {}", name,
                       order);
  }
  return "SELECT * FROM runs WHERE id IN (SELECT id FROM front) " + order;
}

}  // namespace

Identity study_identity(const problems::Study& study, const StudyOrigin& origin) {
  auto variables = nlohmann::json::array();
  for (const auto& variable : study.variables) variables.push_back(variable.key);
  auto objectives = nlohmann::json::array();
  for (const auto& objective : study.objectives) {
    objectives.push_back({{objective.greatest ? "maximize" : "minimize", objective.name}});
  }
  return {{"format", kStudyFormat},
          {"version", origin.version},
          {"seed", fmt::format("{}", origin.seed)},
          {"title", study.title},
          {"study", origin.text},
          {"base_file", study.base},
          {"base", study.base_text},
          {"drawing", study.drawing},
          {"variables", variables.dump()},
          {"metrics", nlohmann::json(study.metrics).dump()},
          {"objectives", objectives.dump()},
          {"designs", fmt::format("{}", problems::design_count(study))}};
}

std::vector<std::string> study_identity_names() {
  std::vector<std::string> names;
  for (const auto& row : study_identity({}, {})) names.push_back(row.first);
  return names;
}

std::vector<std::string> study_schema(const problems::Study& study) {
  std::string columns;
  for (const auto& name : problems::study_columns(study)) columns += sql_name(name) + ", ";
  std::string counts;
  for (const char* name :
       {"count", "kept", "filtered", "solved", "infeasible", "no_solution", "invalid"}) {
    counts += fmt::format(", {} INTEGER NOT NULL", name);
  }
  return {
      "CREATE TABLE study (name TEXT PRIMARY KEY, value TEXT NOT NULL)",
      fmt::format("CREATE TABLE runs (id INTEGER PRIMARY KEY, {}status TEXT NOT NULL)", columns),
      fmt::format("CREATE TABLE blocks (first INTEGER PRIMARY KEY{})", counts),
      "CREATE TABLE front (id INTEGER PRIMARY KEY)",
      fmt::format("CREATE VIEW best AS {}", best_of(study))};
}

std::string study_difference(const Identity& stored, const Identity& wanted) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  const auto differs = [&](std::string_view name) {
    return value_of(stored, name) != value_of(wanted, name);
  };
  const auto line = [&](std::string_view name) {
    return differing_line(value_of(wanted, name), value_of(stored, name));
  };
  const auto number = [&](const char* what, std::string_view name) {
    add(fmt::format("{} ({} there, {} here)", what, printable(value_of(stored, name)),
                    value_of(wanted, name)));
  };
  if (differs("format")) number("its format", "format");
  if (differs("study")) add(fmt::format("the study file (from line {} on)", line("study")));
  if (differs("base_file")) {
    number("the name of the base file", "base_file");
  }
  if (differs("base")) add(fmt::format("the base file (from line {} on)", line("base")));
  if (differs("drawing")) add("the drawing that the base file names");
  if (differs("seed")) number("the seed", "seed");
  if (differs("version")) number("the version of Cognate", "version");
  if (text.empty() && stored != wanted) add("its columns");
  return text;
}

}  // namespace cognate::app
