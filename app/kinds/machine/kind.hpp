/// @file What the program does with `kind = "machine"`.
#pragma once

#include "app/export/exported.hpp"
#include "app/kinds/basics/kind.hpp"
#include "app/report/machine_report_data.hpp"
#include "app/report/page.hpp"
#include "problems/machine/result.hpp"

namespace cognate::app {

template <>
struct Kind<problems::MachineProblem>
    : KindBase<problems::MachineProblem, problems::MachineResult> {
  static constexpr std::string_view kMeaning =
      "the motion of a mechanism with a motor, loads and inertias: steady, start, stop (cognate "
      "analyze)";
  static constexpr const char* kWhenInterrupted =
      "interrupted; the motions found until then are reported";
  static std::string refusal(const problems::MachineProblem& problem, Command command);
  static Result run(const problems::MachineProblem& problem, const problems::Run& run) {
    return problems::run_machine(problem, run);
  }

  /// What moves, what drives it, which motions are requested.
  static std::string describe(const problems::MachineProblem& problem);

  /// The mechanism is the file's, or where it has none a table of type "equivalent" with its
  /// inertia and torque; its origin `given`. Values that do not exist are missing in `metrics`.
  static Json design_json(const problems::MachineProblem& problem, const Result& result,
                          std::size_t index);

  /// `machine` with the table of each motion; values that do not exist are null.
  static void add_findings(Json& document, const problems::MachineProblem& problem,
                           const Result& result);

  /// The status, the quantities and the notes of a run.
  static std::string table(const problems::MachineProblem& problem, const Result& result,
                           const Screen& screen);

  /// The table of all motions, whose columns are the same, with the task before the other columns.
  static std::string csv(const problems::MachineProblem& problem, const Result& result);
  static std::string page(const problems::MachineProblem& /*problem*/, const Result& /*result*/) {
    return machine_page();
  }
  static Json report_data(const problems::MachineProblem& problem, const Result& result) {
    return machine_report_data(problem, result);
  }
  static problems::MetricNames metric_names(const problems::MachineProblem& base);
  static std::vector<ListSection> sections();
  static std::vector<MetricList> metric_lists();

  /// Designs of this type in result files are exported by `export_design`.
  static constexpr std::string_view kOwnType = "equivalent";
  static ExportOutcome export_design(const ResultDesign& design, const ExportOptions& wanted,
                                     const std::string& stem);
};

}  // namespace cognate::app
