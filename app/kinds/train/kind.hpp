/// @file What the program does with `kind = "gear-train"`.
#pragma once

#include "app/export/exported.hpp"
#include "app/kinds/basics/kind.hpp"
#include "app/report/page.hpp"
#include "app/report/train_report_data.hpp"
#include "problems/train/result.hpp"

namespace cognate::app {

template <>
struct Kind<problems::GearTrainProblem>
    : KindBase<problems::GearTrainProblem, problems::GearTrainResult> {
  static constexpr std::string_view kMeaning =
      "a gear train or gearbox is evaluated, or one is found for a ratio";
  static std::string refusal(const problems::GearTrainProblem& problem, Command command);
  static Result run(const problems::GearTrainProblem& problem, const problems::Run& run) {
    return problems::solve(problem, run);
  }

  /// The title, how many members and meshes or which ratio, and the states.
  static std::string describe(const problems::GearTrainProblem& problem);

  /// `mechanism` is a table of type "gear-train" with all that gives the train; `metrics` has each
  /// member's under `members`, and `meshes`.
  static Json design_json(const problems::GearTrainProblem& problem, const Result& result,
                          std::size_t index);

  /// A row for each design or state; of one alone every figure, every member and mesh.
  static std::string table(const problems::GearTrainProblem& problem, const Result& result,
                           const Screen& screen);
  static std::string page(const problems::GearTrainProblem& /*problem*/, const Result& /*result*/) {
    return train_page();
  }
  static Json report_data(const problems::GearTrainProblem& /*problem*/, const Result& result) {
    return train_report_data(result);
  }
  static problems::MetricNames metric_names(const problems::GearTrainProblem& base);
  static std::vector<ListSection> sections();
  static std::vector<MetricList> metric_lists();

  /// Designs of this type in result files are exported by `export_design`.
  static constexpr std::string_view kOwnType = "gear-train";
  static ExportOutcome export_design(const ResultDesign& design, const ExportOptions& wanted,
                                     const std::string& stem);
};

}  // namespace cognate::app
