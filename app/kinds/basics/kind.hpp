/// @file What the program does with problems of one kind.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/console/screen.hpp"
#include "app/console/table_text.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/list_section.hpp"
#include "app/documents/result_json.hpp"
#include "app/kinds/basics/command.hpp"
#include "app/report/report.hpp"
#include "problems/basics/kind.hpp"
#include "problems/linkage/result.hpp"
#include "problems/study/metric_names.hpp"
#include "problems/toml/document.hpp"
#include "problems/toml/fault.hpp"

namespace cognate::app {

/// How a design of a study came out, and its entry of `designs` in the result document.
struct Evaluated {
  problems::Status status = problems::Status::no_solution;
  nlohmann::ordered_json design;
};

/// What each kind of problem defines in its folder, in addition to `KindBase`:
/// - `kMeaning`, a line of `cognate list`;
/// - `refusal(problem, command)`, why a command does not take it; empty where it does;
/// - `run(problem, run)`, its result;
/// - `describe(problem)`, its summary in a line;
/// - `design_json(problem, result, i)`, entry i of `designs` in the result document;
/// - `table(problem, result, screen)`, what the terminal shows;
/// - `page(problem)` and `report_data(problem, result)`, the report and what it draws;
/// - `metric_names(base)`, the metrics of its designs for a study;
/// - if there is a table of numbers, `csv(problem, result)`, or `csv(problem, result, steps)` if
///   its rows are in equal steps.
template <class Problem>
struct Kind;

template <class Problem>
using ResultOf = typename Kind<Problem>::Result;

template <class Problem, class ResultType>
struct KindBase {
  using Result = ResultType;
  using Json = nlohmann::ordered_json;

  static constexpr const char* kWhenInterrupted =
      "interrupted; what was found until then is reported";

  /// What is wrong with the files that a sound problem names.
  static std::vector<problems::Fault> faults(const Problem& /*problem*/) { return {}; }

  /// Designs for the search to begin with, or the faults of the files that give them.
  static tl::expected<std::vector<problems::Design>, std::vector<problems::Fault>> known_designs(
      const Problem& /*problem*/) {
    return {};
  }

  static std::size_t design_count(const Result& result) {
    if constexpr (requires { result.designs; }) return result.designs.size();
    return 1;
  }

  /// Whether the exit status says that all is done.
  static bool is_done(const Result& result) {
    using problems::Status;
    if constexpr (requires { result.designs; }) {
      const bool stopped =
          result.status == Status::time_limit || result.status == Status::interrupted;
      if (stopped) return feasible_count(result) > 0;
    }
    return result.status == Status::solved;
  }

  /// Single numbers that a result reports with its designs, into its document or, of a study,
  /// into the best design.
  static void add_facts(Json& /*table*/, const Result& /*result*/) {}

  /// What a result reports with its designs.
  static void add_findings(Json& document, const Problem& /*problem*/, const Result& result) {
    Kind<Problem>::add_facts(document, result);
  }

  /// A design of a study, of which `names` are asked.
  static Evaluated evaluate(const Problem& problem, const std::vector<std::string>& /*names*/,
                            const problems::Run& run) {
    const Result result = Kind<Problem>::run(problem, run);
    return {result.status, best_design_json(problem, result)};
  }

  /// The best design, where there is one, with the facts. Not all numbers need be finite.
  static Json best_design_json(const Problem& problem, const Result& result) {
    Json design =
        design_count(result) == 0 ? Json::object() : Kind<Problem>::design_json(problem, result, 0);
    Kind<Problem>::add_facts(design, result);
    return design;
  }

  /// The tables and metrics that `cognate list` shows of this kind alone.
  static std::vector<ListSection> sections() { return {}; }
  static std::vector<MetricList> metric_lists() { return {}; }
};

/// What a result warns of; nothing where its kind has no warnings.
template <class Result>
std::vector<std::string> warnings_of(const Result& result) {
  if constexpr (requires { result.warnings; }) return result.warnings;
  return {};
}

/// The tables of the file of a problem under their own keys with every default filled in, angles in
/// degrees where the key ends in `_deg`; what has no value is left out.
template <class Problem>
nlohmann::ordered_json problem_json(const Problem& problem) {
  return to_json(problems::KindTraits<Problem>::written(problem).document);
}

/// The document `cognate-result/1` of a run: `format`, `version`, `seed`, `status`, `problem`,
/// `designs` (best first), what else the kind has, `notes`, `work`, as
/// `schema/cognate-result-1.schema.json` describes. Angles are in degrees under keys that end in
/// `_deg`.
///
/// The error says which number was NaN or infinite: no such document may be written.
template <class Problem>
tl::expected<nlohmann::ordered_json, std::string> result_document(const Problem& problem,
                                                                  const ResultOf<Problem>& result,
                                                                  std::uint64_t seed) {
  using K = Kind<Problem>;
  auto document = document_head(result.status, seed, problem_json(problem));
  auto& designs = document["designs"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < K::design_count(result); ++i) {
    designs.push_back(K::design_json(problem, result, i));
  }
  K::add_findings(document, problem, result);
  return finished_document(std::move(document), {result.notes, warnings_of(result)}, result.work);
}

/// A whole HTML page that opens from disk and loads nothing: `document` (that of `result`, embedded
/// but for tables that would make the page too large) and what is drawn, sampled by the analysis
/// kernel. Text of the user's cannot become markup.
template <class Problem>
std::string report_html(const nlohmann::ordered_json& document, const Problem& problem,
                        const ResultOf<Problem>& result) {
  return report_page(Kind<Problem>::page(problem, result),
                     Kind<Problem>::report_data(problem, result), document);
}

}  // namespace cognate::app
