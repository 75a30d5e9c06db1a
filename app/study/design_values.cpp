#include "app/study/design_values.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/console/design_dimensions.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/result_json.hpp"
#include "app/kinds/cam/json.hpp"
#include "app/kinds/evaluation/problem_json.hpp"
#include "app/kinds/gear/json.hpp"
#include "app/kinds/machine/json.hpp"
#include "app/study/cache_folder.hpp"
#include "problems/evaluation/curve_metrics.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/result.hpp"
#include "problems/machine/result.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;
using problems::CamProblem;
using problems::Cell;
using problems::Problem;
using problems::RunStatus;
using problems::Status;

using Names = std::vector<std::string>;

std::optional<RunStatus> run_status(Status status) {
  switch (status) {
    case Status::solved:
      return RunStatus::solved;
    case Status::infeasible:
      return RunStatus::infeasible;
    case Status::no_solution:
      return RunStatus::no_solution;
    case Status::time_limit:
    case Status::interrupted:
      break;
  }
  return std::nullopt;
}

bool any_starts(const Names& names, std::initializer_list<std::string_view> openings) {
  return std::ranges::any_of(names, [&](const std::string& name) {
    return std::ranges::any_of(openings, [&](auto opening) { return name.starts_with(opening); });
  });
}

/// The size of a four-bar, which its dimensions tell.
void add_size(ordered_json& metrics, const problems::NamedMechanism& mechanism) {
  if (!mechanism.four_bar) return;
  const auto [shortest, longest] =
      std::ranges::minmax(dimensions(mechanism), {}, &Dimension::value);
  metrics["longest_link"] = longest.value;
  metrics["link_ratio"] = longest.value / shortest.value;
}

/// What a design is and has, and how it came out.
struct Evaluated {
  Status status = Status::no_solution;
  ordered_json design;
};

struct Evaluation {
  const Names& names;
  const problems::Run& run;

  Evaluated operator()(const Problem& problem) const {
    const auto result =
        std::visit([&](const auto& asked) { return problems::solve(asked, run); }, problem);
    Evaluated evaluated{result.status, best_design_json(problem, result)};
    if (!result.designs.empty()) {
      add_size(evaluated.design["metrics"], result.designs.front().mechanism);
    }
    return evaluated;
  }

  Evaluated operator()(const CamProblem& problem) const {
    const auto result = problems::solve(problem, run);
    return {result.status, best_design_json(problem, result)};
  }

  Evaluated operator()(const problems::GearProblem& problem) const {
    const auto result = problems::analyse(problem, run);
    return {result.status, best_design_json(problem, result)};
  }

  Evaluated operator()(const problems::GearPairProblem& problem) const {
    const auto result = problems::solve(problem, run);
    return {result.status, best_design_json(problem, result)};
  }

  Evaluated operator()(const AnalysisProblem& problem) const {
    AnalysisProblem asked = problem;
    asked.output = needed_output();
    const auto result = problems::analyse(asked, run);
    Evaluated evaluated{result.status, ordered_json::object()};
    if (result.closed_rows == 0) return evaluated;
    ordered_json& metrics = evaluated.design["metrics"];
    add_facts(metrics, result.facts);
    add_facts(metrics, facts_of_curve(problem));
    metrics["defects"] = ordered_json::array();
    if (any_starts(names, {"mechanism."})) {
      evaluated.design["mechanism"] = mechanism_json(asked.mechanism);
    }
    return evaluated;
  }

  Evaluated operator()(const problems::MachineProblem& problem) const {
    const auto result = problems::run_machine(problem, run);
    Evaluated evaluated{result.status, {{"mechanism", machine_mechanism_json(problem)}}};
    add_finite_facts(evaluated.design["metrics"], result.facts);
    return evaluated;
  }

  /// Those of the coupler curve that have a name here.
  std::vector<problems::Fact> facts_of_curve(const AnalysisProblem& problem) const {
    std::vector<problems::Fact> facts;
    if (!problem.mechanism.four_bar) return facts;
    const FourBar& linkage = *problem.mechanism.four_bar;
    problems::CurveValues values;
    values.begin(linkage, circuit_at(linkage, problem.drive.start));
    for (const auto& metric : problems::curve_metrics()) {
      if (std::ranges::find(names, metric.key) == names.end()) continue;
      if (const auto value = values(metric)) facts.push_back({std::string(metric.key), *value});
    }
    return facts;
  }

  /// The facts of the motion need no column but those of forces.
  problems::AnalysisOutput needed_output() const {
    problems::AnalysisOutput output = no_columns();
    output.reactions = any_starts(names, {"reaction_max", "power_residual"});
    output.torque = any_starts(names, {"torque_N_m", "drive_force_N", "power_residual"});
    return output;
  }
};

/// What is left of `name` below `key`; empty where it leads elsewhere.
std::optional<std::string_view> below(std::string_view name, std::string_view key) {
  if (!name.starts_with(key)) return std::nullopt;
  name.remove_prefix(key.size());
  if (name.empty() || name.front() == '[') return name;
  return name.front() == '.' ? std::optional(name.substr(1)) : std::nullopt;
}

Cell list_of_words(const ordered_json& list) {
  std::string words;
  for (const auto& word : list) {
    if (!word.is_string()) return {};
    if (!words.empty()) words += ',';
    words += word.get_ref<const std::string&>();
  }
  return words.empty() ? Cell("none") : Cell(std::move(words));
}

Cell cell(const ordered_json& value) {
  if (value.is_boolean()) return std::string(value.get<bool>() ? "true" : "false");
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) return list_of_words(value);
  if (!value.is_number()) return {};
  const double number = value.get<double>();
  return std::isfinite(number) ? Cell(number) : Cell{};
}

/// The entry of `list` that "[12]…" names.
Cell entry_at(const ordered_json& list, std::string_view name) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), index);
  const auto used = static_cast<std::size_t>(end - name.data());
  const bool whole = error == std::errc{} && used < name.size() && *end == ']';
  if (!whole || !list.is_array() || index >= list.size()) return {};
  name.remove_prefix(used + 1);
  return value_at(list[index], name.starts_with('.') ? name.substr(1) : name);
}

}  // namespace

std::optional<DesignOutcome> evaluate(const problems::Task& task, const Names& names,
                                      std::uint64_t seed, const std::atomic<bool>* interrupted) {
  problems::Run run;
  run.seed = seed;
  run.threads = 1;
  run.interrupted = interrupted;
  run.cache = cache_folder();
  const auto evaluated = std::visit(Evaluation{names, run}, task);
  const auto status = run_status(evaluated.status);
  if (!status) return std::nullopt;
  DesignOutcome outcome{*status, {}};
  for (const std::string& name : names) {
    Cell value =
        evaluated.design.contains("metrics") ? value_at(evaluated.design["metrics"], name) : Cell{};
    const bool none = std::holds_alternative<std::monostate>(value);
    outcome.values.push_back(none ? value_at(evaluated.design, name) : std::move(value));
  }
  return outcome;
}

problems::AnalysisOutput no_columns() {
  problems::AnalysisOutput output;
  for (bool problems::AnalysisOutput::*quantity :
       {&problems::AnalysisOutput::position, &problems::AnalysisOutput::velocity,
        &problems::AnalysisOutput::acceleration, &problems::AnalysisOutput::transmission}) {
    output.*quantity = false;
  }
  return output;
}

Cell value_at(const ordered_json& table, std::string_view name) {
  if (name.empty()) return cell(table);
  if (name.front() == '[') return entry_at(table, name);
  if (!table.is_object()) return {};
  for (const auto& [key, value] : table.items()) {
    if (const auto rest = below(name, key)) return value_at(value, *rest);
  }
  return {};
}

void add_values(std::vector<problems::MetricName>& names, const ordered_json& value,
                const std::string& name) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) add_values(names, inner, name + '.' + key);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      add_values(names, value[i], fmt::format("{}[{}]", name, i));
    }
  } else if (!value.is_null()) {
    names.push_back({name, !value.is_number()});
  }
}

}  // namespace cognate::app
