#include "app/study/design_values.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/kinds/kinds.hpp"
#include "app/study/cache_folder.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::Cell;
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
    case Status::invalid:
      return RunStatus::invalid;
    case Status::time_limit:
    case Status::interrupted:
      break;
  }
  return std::nullopt;
}

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
  const auto evaluated = visit_kind(
      task, [&](auto kind, const auto& problem) { return kind.evaluate(problem, names, run); });
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
