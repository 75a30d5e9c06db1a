#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/console/text_table.hpp"
#include "app/documents/catalogue.hpp"
#include "app/documents/mechanism_catalogue.hpp"
#include "app/documents/problem_catalogue.hpp"
#include "app/documents/result_json.hpp"
#include "app/documents/version.hpp"
#include "app/kinds/cam/catalogue.hpp"
#include "app/kinds/gear/catalogue.hpp"
#include "app/kinds/machine/catalogue.hpp"
#include "app/study/catalogue.hpp"
#include "app/study/metrics.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

std::vector<Entry> solvers() {
  std::vector<Entry> all;
  for (const auto& named : problems::names<problems::SolverChoice>()) {
    all.push_back({named.name, meaning(named.value)});
  }
  return all;
}

std::string section(const std::string& heading, std::span<const Entry> entries) {
  std::string text = heading + '\n';
  std::size_t width = 0;
  for (const auto& entry : entries) width = std::max(width, entry.name.size());
  for (const auto& entry : entries) {
    text += fmt::format("  {:<{}}  {}\n", entry.name, width, entry.meaning);
  }
  return text;
}

std::string keyed_section(const std::string& heading, std::span<const KeyedEntry> entries) {
  std::string text = heading + '\n';
  for (const auto& entry : entries) {
    text += fmt::format("  {}: {}\n", entry.name, entry.meaning);
    std::size_t width = 0;
    for (const auto& key : entry.keys) width = std::max(width, key.name.size());
    for (const auto& key : entry.keys) {
      text += fmt::format("      {:<{}}  {}\n", key.name, width, key.meaning);
    }
  }
  return text;
}

std::string factor(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "inf";
}

/// A computed factor, and in brackets the handbook's; nothing where the law has parameters.
std::string factors(const MotionLawEntry& law, double cam::PeakFactors::*of) {
  std::string text = law.factors ? factor((*law.factors).*of) : "";
  if (law.handbook) text += fmt::format(" ({})", factor((*law.handbook).*of));
  return text;
}

std::string motion_law_section() {
  Column names{"  law", Align::left, {}};
  Column velocity{"velocity", Align::right, {}}, acceleration{"acceleration", Align::right, {}},
      jerk{"jerk", Align::right, {}}, meanings{"", Align::left, {}};
  for (const auto& law : motion_laws()) {
    names.cells.push_back("  " + std::string(law.name));
    velocity.cells.push_back(factors(law, &cam::PeakFactors::velocity));
    acceleration.cells.push_back(factors(law, &cam::PeakFactors::acceleration));
    jerk.cells.push_back(factors(law, &cam::PeakFactors::jerk));
    meanings.cells.emplace_back(law.meaning);
  }
  std::string text =
      "motion laws of cams (motion.law = ...): greatest values for a rise of 1 over a cam angle of "
      "1,"
      " in brackets\nthose that handbooks print\n";
  for (const auto& line : set_columns({names, velocity, acceleration, jerk, meanings})) {
    text += line + '\n';
  }
  return text;
}

std::string cam_text() {
  return keyed_section("followers of cams (follower.type = ...) and their lengths in [mechanism]",
                       cam_followers()) +
         '\n' + keyed_section("tables of a cam", cam_tables()) + '\n' + motion_law_section();
}

std::string gear_text() {
  return keyed_section("tables of a gear", gear_tables()) + '\n' +
         keyed_section("tables of a gear pair", gear_pair_tables());
}

std::string study_text() {
  return keyed_section("tables of a study, which cognate sweep runs", study_tables()) + '\n' +
         section("samplings of a study (vary.sampling = ...)", samplings());
}

std::string capabilities_text() {
  return section("problem kinds (kind = ...)", problem_kinds()) + '\n' +
         keyed_section("keys of the kinds that cognate solve takes", synthesis_problems()) + '\n' +
         keyed_section("tables of all these kinds", common_tables()) + '\n' + cam_text() + '\n' +
         gear_text() + '\n' + section("options of [solve]", solve_options()) + '\n' +
         section("solvers (solve.solver = ...)", solvers()) + '\n' +
         keyed_section(
             "mechanisms to be analysed (mechanism.type = ...) and their keys in [mechanism]",
             mechanisms()) +
         '\n' +
         keyed_section(
             "dyads of a chain (dyad.type = ...; names = [\"...\", \"...\"] of the bodies)",
             dyads()) +
         '\n' + keyed_section("tables of an analysis", analysis_tables()) + '\n' +
         keyed_section("tables of a machine", machine_tables()) + '\n' + study_text();
}

std::string metrics_section(const std::string& heading, std::span<const Metric> all) {
  Column keys{heading, Align::left, {}};
  Column units{"unit", Align::left, {}};
  Column meanings{"meaning", Align::left, {}};
  for (const auto& metric : all) {
    keys.cells.emplace_back(metric.key);
    units.cells.emplace_back(metric.unit);
    meanings.cells.emplace_back(metric.meaning);
  }
  std::string text;
  for (const auto& line : set_columns({keys, units, meanings})) text += line + '\n';
  return text;
}

std::string metrics_text() {
  return metrics_section("metric of a design", metrics()) + '\n' +
         metrics_section("metric of a cam", cam_metrics()) + '\n' +
         metrics_section("metric of a gear (of a pair: pinion., wheel. or worm. before it)",
                         gear_metrics()) +
         '\n' + metrics_section("metric of a gear pair", gear_pair_metrics()) + '\n' +
         metrics_section("column of a gear", gear_columns()) + '\n' +
         metrics_section("fact of a synthesis", facts()) + '\n' +
         metrics_section("further metric of a study", study_extras()) + '\n' +
         metrics_section("metric of an analysis", analysis_metrics()) + '\n' +
         metrics_section("column of an analysis", analysis_columns()) + '\n' +
         metrics_section("metric of a machine", machine_metrics()) + '\n' +
         metrics_section("column of a machine", machine_columns());
}

ordered_json entries_json(std::span<const Entry> entries) {
  ordered_json rows = ordered_json::array();
  for (const auto& entry : entries) {
    rows.push_back({{"name", entry.name}, {"meaning", entry.meaning}});
  }
  return rows;
}

ordered_json keyed_json(std::span<const KeyedEntry> entries) {
  ordered_json rows = ordered_json::array();
  for (const auto& entry : entries) {
    rows.push_back(
        {{"name", entry.name}, {"meaning", entry.meaning}, {"keys", entries_json(entry.keys)}});
  }
  return rows;
}

ordered_json metrics_json(std::span<const Metric> all) {
  ordered_json rows = ordered_json::array();
  for (const auto& metric : all) {
    rows.push_back({{"key", metric.key}, {"unit", metric.unit}, {"meaning", metric.meaning}});
  }
  return rows;
}

/// Infinity has no JSON number: null.
ordered_json factors_json(const std::optional<cam::PeakFactors>& factors) {
  if (!factors) return nullptr;
  const auto number = [](double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(); };
  return {{"velocity", number(factors->velocity)},
          {"acceleration", number(factors->acceleration)},
          {"jerk", number(factors->jerk)}};
}

ordered_json motion_laws_json() {
  ordered_json rows = ordered_json::array();
  for (const auto& law : motion_laws()) {
    rows.push_back({{"name", law.name},
                    {"meaning", law.meaning},
                    {"peak_factors", factors_json(law.factors)},
                    {"handbook", factors_json(law.handbook)}});
  }
  return rows;
}

ordered_json list_json(bool with_metrics) {
  ordered_json document = {{"format", "cognate-list/1"}, {"version", version()}};
  if (with_metrics) {
    document["metrics"] = metrics_json(metrics());
    document["cam_metrics"] = metrics_json(cam_metrics());
    document["gear_metrics"] = metrics_json(gear_metrics());
    document["gear_pair_metrics"] = metrics_json(gear_pair_metrics());
    document["gear_columns"] = metrics_json(gear_columns());
    document["facts"] = metrics_json(facts());
    document["study_metrics"] = metrics_json(study_extras());
    document["analysis_metrics"] = metrics_json(analysis_metrics());
    document["analysis_columns"] = metrics_json(analysis_columns());
    document["machine_metrics"] = metrics_json(machine_metrics());
    document["machine_columns"] = metrics_json(machine_columns());
    return document;
  }
  document["problem_kinds"] = entries_json(problem_kinds());
  document["synthesis_problems"] = keyed_json(synthesis_problems());
  document["common_tables"] = keyed_json(common_tables());
  document["cam_followers"] = keyed_json(cam_followers());
  document["cam_tables"] = keyed_json(cam_tables());
  document["gear_tables"] = keyed_json(gear_tables());
  document["gear_pair_tables"] = keyed_json(gear_pair_tables());
  document["motion_laws"] = motion_laws_json();
  document["mechanisms"] = keyed_json(mechanisms());
  document["dyads"] = keyed_json(dyads());
  document["analysis_tables"] = keyed_json(analysis_tables());
  document["machine_tables"] = keyed_json(machine_tables());
  document["study_tables"] = keyed_json(study_tables());
  document["samplings"] = entries_json(samplings());
  document["solvers"] = entries_json(solvers());
  document["solve_options"] = entries_json(solve_options());
  return document;
}

}  // namespace

ExitStatus list_command(bool metrics, const Options& options) {
  if (options.json) return print(write_json(list_json(metrics)));
  return print(fitted(metrics ? metrics_text() : capabilities_text(), standard_output()));
}

}  // namespace cognate::app
