#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <type_traits>

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

std::vector<ListSection> listed(std::span<const MetricList> lists) {
  std::vector<ListSection> all;
  for (const MetricList& list : lists) all.push_back(list_section(list));
  return all;
}

/// Whether designs of this kind are linkages, with the metrics and the tables that these share.
template <class Problem>
constexpr bool designs_linkages = requires {
  Kind<Problem>::kMethods;
};

template <class Problem>
std::vector<ListSection> keys_of_kind() {
  std::vector<ListSection> all;
  if constexpr (designs_linkages<Problem>) {
    const KeyedEntry own{KindTraits<Problem>::kWord, Kind<Problem>::kMethods,
                         Kind<Problem>::keys()};
    all = {
        list_section("synthesis_problems", "keys of this kind", {&own, 1}),
        list_section("common_tables", "tables of all kinds that design a linkage", common_tables()),
        list_section("solvers", "solvers (solve.solver = ...)", solvers()),
        list_section("solve_options", "options of [solve]", solve_options())};
  }
  if constexpr (std::is_same_v<Problem, problems::MachineProblem>) {
    all = Kind<problems::AnalysisProblem>::sections();  // its [mechanism], [[link]] and [[load]]
  }
  std::ranges::move(Kind<Problem>::sections(), std::back_inserter(all));
  return all;
}

template <class Problem>
std::vector<ListSection> metrics_of_kind() {
  std::vector<ListSection> all = listed(Kind<Problem>::metric_lists());
  if constexpr (designs_linkages<Problem>) {
    for (const MetricList& list : metric_lists()) {
      if (list.key == "metrics" || list.key == "facts") all.push_back(list_section(list));
    }
  }
  return all;
}

/// Of the kind called `kind`; nothing where there is none.
std::vector<ListSection> of_kind(const std::string& kind, bool metrics) {
  if (kind == "study" && metrics) return listed(metric_lists());
  if (kind == "study") {
    return {list_section("study_tables", "tables of a study", study_tables()),
            list_section("samplings", "samplings of a study (vary.sampling = ...)", samplings())};
  }
  std::vector<ListSection> all;
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    if (kind != KindTraits<Problem>::kWord) return;
    all = metrics ? metrics_of_kind<Problem>() : keys_of_kind<Problem>();
  });
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

ExitStatus list_command(const std::string& kind, bool metrics, const Options& options) {
  const auto all = [&] { return metrics ? listed(metric_lists()) : capabilities(); };
  const auto sections = kind.empty() ? all() : of_kind(kind, metrics);
  if (sections.empty()) {
    complain(unknown_kind(kind));
    return exit_bad_input;
  }
  if (options.json) return print(write_json(document_of(sections)));
  return print(fitted(text_of(sections), standard_output()));
}

}  // namespace cognate::app
