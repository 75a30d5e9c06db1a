/// @file What the program does with `kind = "analysis"`.
#pragma once

#include "app/kinds/basics/kind.hpp"
#include "app/report/analysis_report_data.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::app {

template <>
struct Kind<problems::AnalysisProblem>
    : KindBase<problems::AnalysisProblem, problems::AnalysisResult> {
  static constexpr std::string_view kMeaning =
      "a given mechanism is evaluated over its drive (cognate analyze)";
  static constexpr const char* kWhenInterrupted =
      "interrupted; what was computed until then is reported";
  static std::string refusal(const problems::AnalysisProblem& problem, Command command);
  static Result run(const problems::AnalysisProblem& problem, const problems::Run& run) {
    return problems::analyse(problem, run);
  }
  static bool is_done(const Result& result) { return result.closed_rows > 0; }

  /// The title, the mechanism's type, and its drive.
  static std::string describe(const problems::AnalysisProblem& problem);

  /// The mechanism of the file, its origin `given`, with the drive's position at each row
  /// (`crank_deg`, or `slide` for a driving slider) and the quantities of its motion as `metrics`.
  static Json design_json(const problems::AnalysisProblem& problem, const Result& result,
                          std::size_t index);

  /// `analysis`: the columns (null where the mechanism cannot be assembled) and the landmarks.
  static void add_findings(Json& document, const problems::AnalysisProblem& problem,
                           const Result& result);

  /// The design without what `names` do not ask for.
  static Evaluated evaluate(const problems::AnalysisProblem& problem,
                            const std::vector<std::string>& names, const problems::Run& run);

  /// A heading, the status in words, the quantities and the landmarks as tables, the notes, and the
  /// time. On a screen with colours these mark the status.
  static std::string table(const problems::AnalysisProblem& problem, const Result& result,
                           const Screen& screen);
  static std::string csv(const problems::AnalysisProblem& problem, const Result& result);
  static std::string page(const problems::AnalysisProblem& problem,
                          const problems::AnalysisResult& result);
  static Json report_data(const problems::AnalysisProblem& problem, const Result& result);
  static problems::MetricNames metric_names(const problems::AnalysisProblem& base);
  static std::vector<ListSection> sections();
  static std::vector<MetricList> metric_lists();
};

}  // namespace cognate::app
