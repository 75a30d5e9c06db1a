#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/documents/problem_catalogue.hpp"
#include "app/documents/version.hpp"
#include "app/kinds/kinds.hpp"
#include "app/study/catalogue.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::KindTraits;

std::vector<Entry> solvers() {
  std::vector<Entry> all;
  for (const auto& named : problems::names<synthesis::Solver>()) {
    all.push_back({named.name, meaning(named.value)});
  }
  return all;
}

std::vector<Entry> kinds() {
  std::vector<Entry> all{
      {"study", "any of these with other numbers, as many designs as wanted (cognate sweep)"}};
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    all.push_back({KindTraits<Problem>::kWord, Kind<Problem>::kMeaning});
  });
  std::ranges::sort(all, {}, &Entry::name);
  return all;
}

std::vector<KeyedEntry> linkage_kinds() {
  std::vector<KeyedEntry> all;
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    if constexpr (requires { Kind<Problem>::kMethods; }) {
      all.push_back({KindTraits<Problem>::kWord, Kind<Problem>::kMethods, Kind<Problem>::keys()});
    }
  });
  std::ranges::sort(all, {}, &KeyedEntry::name);
  return all;
}

std::vector<ListSection> capabilities() {
  std::vector<ListSection> all{
      list_section("problem_kinds", "problem kinds (kind = ...)", kinds()),
      list_section("synthesis_problems", "keys of the kinds that cognate solve takes",
                   linkage_kinds()),
      list_section("common_tables", "tables of all these kinds", common_tables())};
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    std::ranges::move(Kind<Problem>::sections(), std::back_inserter(all));
  });
  all.push_back(
      list_section("study_tables", "tables of a study, which cognate sweep runs", study_tables()));
  all.push_back(
      list_section("samplings", "samplings of a study (vary.sampling = ...)", samplings()));
  all.push_back(list_section("solvers", "solvers (solve.solver = ...)", solvers()));
  all.push_back(list_section("solve_options", "options of [solve]", solve_options()));
  return all;
}

std::vector<ListSection> metric_sections() {
  std::vector<ListSection> all;
  for (const MetricList& list : metric_lists()) all.push_back(list_section(list));
  return all;
}

std::string text_of(const std::vector<ListSection>& sections) {
  std::string text;
  for (const auto& section : sections) text += (text.empty() ? "" : "\n") + section.text;
  return text;
}

ordered_json document_of(const std::vector<ListSection>& sections) {
  ordered_json document = {{"format", "cognate-list/1"}, {"version", version()}};
  for (const auto& section : sections) document[std::string(section.key)] = section.json;
  return document;
}

}  // namespace

ExitStatus list_command(bool metrics, const Options& options) {
  const auto sections = metrics ? metric_sections() : capabilities();
  if (options.json) return print(write_json(document_of(sections)));
  return print(fitted(text_of(sections), standard_output()));
}

}  // namespace cognate::app
