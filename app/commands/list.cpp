#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/documents/catalogue.hpp"
#include "app/documents/layers_catalogue.hpp"
#include "app/documents/mechanism_catalogue.hpp"
#include "app/documents/tolerance_catalogue.hpp"
#include "app/documents/version.hpp"
#include "app/kinds/kinds.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/keys.hpp"
#include "problems/linkage/warning_keys.hpp"
#include "problems/raster/keys.hpp"

namespace cognate::app {
namespace {

constexpr Entry kFile[] = {
    {"kind", "\"study\"; may be left out"},
    {"title", "of the study"},
    {"base", "the problem or mechanism file whose numbers vary, relative to this one"}};

constexpr Entry kVary[] = {
    {"key",
     "the place of a number of the base: \"mechanism.crank\", \"target.points[2][0]\", entries "
     "counted from 0"},
    {"range", "[a, b], with steps, or with sampling and count"},
    {"steps", "how many values, in equal steps, both ends included"},
    {"values", "or: these, [x, ...]"},
    {"sampling", "one of the samplings below, the same for all variables that are sampled"},
    {"count", "how many samples, the same for all of these"},
    {"scale", "of a range: \"linear\" (default), or \"log\": steps or samples of the logarithm"}};

constexpr Entry kOutput[] = {
    {"metrics", "names of 'cognate list --metrics', or places in a design of the result document"},
    {"rows", "\"passed\" (default): those that pass the filters, or \"all\""}};

constexpr Entry kFilter[] = {
    {"METRIC or KEY",
     "[min, max], {min = x}, {max = x}; of words \"a\", [\"a\", \"b\"], true, "
     "false"}};

constexpr Entry kObjective[] = {
    {"minimize, maximize", "a metric or varied key, or a list of them: a Pareto front"}};

constexpr KeyedEntry kTables[] = {
    {"the file", "numbers of a base file vary; cognate sweep runs all designs", kFile},
    {"[[vary]]", "a number of the base", kVary},
    {"[output]", "the columns of rows in addition to the variables", kOutput},
    {"[filter]", "which rows are kept", kFilter},
    {"[objective]", "which rows are best", kObjective}};

constexpr Entry kSamplings[] = {
    {"sobol", "Sobol's sequence, shifted at random by --seed (0: as published); best with 2^k"},
    {"halton", "Halton's sequence, its digits permuted at random by --seed (0: as published)"},
    {"latin", "a Latin hypercube: of count equal parts of every range each holds one sample"},
    {"random", "independent and uniform"}};

/// The keys of a study, table by table.
std::span<const KeyedEntry> study_tables() {
  return kTables;
}

/// The values of `vary.sampling`.
std::span<const Entry> samplings() {
  return kSamplings;
}

constexpr Entry kBounds[] = {
    {"length", "[min, max] of every link; crank, coupler, rocker, frame: of one"},
    {"pivot_a, pivot_d", "[[xmin, ymin], [xmax, ymax]]"},
    {"coupler_point", "[[umin, vmin], [umax, vmax]]"},
    {"frame_angle_deg, input_start_deg, output_start_deg, output_start", "[min, max]"}};

namespace keys = problems::reading;

constexpr auto kDesignConstraints =
    entries_of(keys::kMobilityKeys, keys::kErrorKeys, keys::kPlaceLimitKeys, keys::kLayersMaxKeys);
constexpr auto kMotionConstraints = entries_of(keys::kDefectKeys, keys::kLoopKeys);

constexpr auto kConstraints = with_cycle_quantities(
    kDesignConstraints,
    [](const problems::CycleDeclaration& of) {
      return Entry{of.limit_key, of.limit_meaning};
    },
    kMotionConstraints);

constexpr Entry kDrive[] = {
    {"speed",
     "of the crank, rad/s: constant (default 1), or the mean of a speed that may fluctuate; or "
     "speed_rpm, in turns a minute"}};

constexpr Entry kFlywheel[] = {{"inertia", "on the crank, for speed_fluctuation_max (default 0)"},
                               {"fluctuation", "that it is to leave, for flywheel_inertia_max"}};

constexpr Entry kLink[] = {
    {"name, between",
     "\"crank\", \"coupler\" or \"rocker\"; or two of its joints, as [\"B\", \"C\"]"},
    {"mass_per_length", "in kg/length, of a slender rod as long as the link"},
    {"mass, centre, inertia", "or: given once and for all, [u, v] in the link's axes"}};

constexpr Entry kLoad[] = {
    {"on, at", "\"coupler-point\", \"B\", \"C\", or a link and [u, v] in its axes"},
    {"force, torque", "[fx, fy] and a torque"},
    {"when",
     "\"always\" (default); on the rocker of a crank-rocker \"advance\" (while it turns "
     "counter-clockwise) or \"return\""}};

constexpr auto kWarnings = entries_of(problems::reading::kWarningKeys);

constexpr KeyedEntry kCommon[] = {
    {"[bounds]", "of what is sought", kBounds},
    {"[constraints]", "on the designs", kConstraints},
    {"[drive]", "for peak accelerations, torques, speeds and powers over the turn", kDrive},
    {"[flywheel]", "for speed_fluctuation_max and flywheel_inertia_max", kFlywheel},
    {"[[link]]", "for torques, speeds and powers over the turn, as is gravity = [x, y]", kLink},
    {"[[load]]", "likewise", kLoad},
    {"[warnings]", "from where on designs that meet every constraint are warned of", kWarnings},
    {"[tolerance]", kToleranceMeaning, kToleranceEntries},
    {"[layers]", problems::reading::kLayersMeaning, kLayersEntries}};

constexpr Entry kHeadKeys[] = {
    {"title", "what tables, reports and drawings are called"},
    {"length_unit",
     "of all lengths: \"mm\", \"cm\", \"m\" or \"in\"; forces are in N, moments in N m, inertias "
     "in "
     "kg m2 for any unit; without it lengths count as m where there are forces"}};

/// The keys of `[raster]`, from their declarations.
std::span<const Entry> raster_entries() {
  static const auto all = [] {
    std::array<Entry, problems::kRasterKeys.size() + 1> entries{};
    for (std::size_t i = 0; i < problems::kRasterKeys.size(); ++i) {
      entries[i] = {problems::kRasterKeys[i].key, problems::kRasterKeys[i].meaning};
    }
    entries.back() = {problems::kRasterBoxesKey, problems::kRasterBoxesMeaning};
    return entries;
  }();
  return all;
}

/// The tables with the same keys in every synthesis problem for which they have a meaning.
std::span<const KeyedEntry> common_tables() {
  static const auto all = [] {
    std::vector<KeyedEntry> tables(std::begin(kCommon), std::end(kCommon));
    tables.push_back(
        {"[raster]",
         "dimensions that take single values only, the best of all combinations "
         "(paths of four-bars and chains, functions, motion generation by least "
         "squares, searches of straight lines, the smallest cams, quick returns, dwells)",
         raster_entries()});
    return tables;
  }();
  return all;
}

using nlohmann::ordered_json;
using problems::KindTraits;

std::vector<Entry> solvers() {
  std::vector<Entry> all;
  for (const auto& solver : synthesis::kSolvers) all.push_back({solver.name, solver.meaning});
  return all;
}

/// Its own where it shares its word with another kind.
template <class Problem>
constexpr std::string_view list_name() {
  if constexpr (requires { Kind<Problem>::kListName; }) return Kind<Problem>::kListName;
  return KindTraits<Problem>::kWord;
}

/// Each word once, with the meaning of its first kind.
std::vector<Entry> kinds() {
  std::vector<Entry> all{
      {"study", "designs for many values of the numbers of a base file (cognate sweep)"}};
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    const auto word = KindTraits<Problem>::kWord;
    if (std::ranges::find(all, word, &Entry::name) != all.end()) return;
    all.push_back({word, Kind<Problem>::kMeaning});
  });
  std::ranges::sort(all, {}, &Entry::name);
  return all;
}

/// The kinds whose designs are linkages, those of one word where `word` is not empty.
std::vector<KeyedEntry> linkage_kinds(std::string_view word = "") {
  std::vector<KeyedEntry> all;
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    if constexpr (requires { Kind<Problem>::kMethods; }) {
      if (!word.empty() && word != KindTraits<Problem>::kWord) return;
      all.push_back({list_name<Problem>(), Kind<Problem>::kMethods, Kind<Problem>::keys()});
    }
  });
  std::ranges::sort(all, {}, &KeyedEntry::name);
  return all;
}

std::vector<ListSection> capabilities() {
  std::vector<ListSection> all{
      list_section("problem_kinds", "problem kinds (kind = ...)", kinds()),
      list_section("head_keys", "keys at the top of any problem, before its tables", kHeadKeys),
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

/// What kinds of one word share is in the sections of each of them.
template <class Problem>
std::vector<ListSection> keys_of_kind() {
  std::vector<ListSection> all;
  if constexpr (designs_linkages<Problem>) {
    all = {
        list_section("synthesis_problems", "keys of this kind",
                     linkage_kinds(KindTraits<Problem>::kWord)),
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
      if (list.key == "metrics" || list.key == "facts" || list.key == "tolerance_metrics" ||
          list.key == "layers_metrics") {
        all.push_back(list_section(list));
      }
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
    for (ListSection& section : metrics ? metrics_of_kind<Problem>() : keys_of_kind<Problem>()) {
      const bool is_new = std::ranges::find(all, section.key, &ListSection::key) == all.end();
      if (is_new) all.push_back(std::move(section));
    }
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

/// Of all kinds where `kind` is empty.
std::vector<ListSection> sections_of(const std::string& kind, bool metrics) {
  if (!kind.empty()) return of_kind(kind, metrics);
  return metrics ? listed(metric_lists()) : capabilities();
}

}  // namespace

std::optional<ordered_json> list_document(const std::string& kind, bool metrics) {
  const auto sections = sections_of(kind, metrics);
  return sections.empty() ? std::nullopt : std::optional(document_of(sections));
}

ExitStatus list_command(const std::string& kind, bool metrics, const Options& options) {
  const auto sections = sections_of(kind, metrics);
  if (sections.empty()) {
    complain(unknown_kind(kind));
    return exit_bad_input;
  }
  if (options.json) return print(write_json(document_of(sections)));
  return print(fitted(text_of(sections), standard_output()));
}

}  // namespace cognate::app
