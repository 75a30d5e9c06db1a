/// @file What the program does with `kind = "gear"` and `kind = "gear-pair"`.
#pragma once

#include "app/export/exported.hpp"
#include "app/kinds/basics/kind.hpp"
#include "app/report/gear_report_data.hpp"
#include "app/report/page.hpp"
#include "problems/gear/result.hpp"

namespace cognate::app {

template <>
struct Kind<problems::GearProblem> : KindBase<problems::GearProblem, problems::GearResult> {
  static constexpr std::string_view kMeaning =
      "a gear as its rack cuts it is evaluated (cognate analyze)";
  static constexpr const char* kWhenInterrupted =
      "interrupted; what was computed until then is reported";
  static std::string refusal(const problems::GearProblem& problem, Command command);
  static Result run(const problems::GearProblem& problem, const problems::Run& run) {
    return problems::analyse(problem, run);
  }

  /// The title, the kind of gearing, teeth and module.
  static std::string describe(const problems::GearProblem& problem);

  /// `mechanism` is a table of type "gear".
  static Json design_json(const problems::GearProblem& problem, const Result& result,
                          std::size_t index);

  /// `gear` with the columns of its flank.
  static void add_findings(Json& document, const problems::GearProblem& problem,
                           const Result& result);

  /// Every quantity of the gear, and what makes it impossible.
  static std::string table(const problems::GearProblem& problem, const Result& result,
                           const Screen& screen);
  static std::string csv(const problems::GearProblem& problem, const Result& result);
  static std::string page(const problems::GearProblem& /*problem*/, const Result& /*result*/) {
    return gear_page();
  }
  static Json report_data(const problems::GearProblem& problem, const Result& result) {
    return gear_report_data(problem, result);
  }
  static problems::MetricNames metric_names(const problems::GearProblem& base);
  static std::vector<ListSection> sections();
  static std::vector<MetricList> metric_lists();

  /// Designs of this type in result files are exported by `export_design`.
  static constexpr std::string_view kOwnType = "gear";
  static ExportOutcome export_design(const ResultDesign& design, const ExportOptions& wanted,
                                     const std::string& stem);
};

template <>
struct Kind<problems::GearPairProblem>
    : KindBase<problems::GearPairProblem, problems::GearPairResult> {
  static constexpr std::string_view kMeaning =
      "two gears mesh; teeth, shifts or centre distance are found";
  static std::string refusal(const problems::GearPairProblem& problem, Command command);
  static Result run(const problems::GearPairProblem& problem, const problems::Run& run) {
    return problems::solve(problem, run);
  }

  /// The title, the kind of gearing, teeth and module, and what of them is free.
  static std::string describe(const problems::GearPairProblem& problem);

  /// `mechanism` is a table of type "gear-pair" with all that gives the pair.
  static Json design_json(const problems::GearPairProblem& problem, const Result& result,
                          std::size_t index);
  static void add_facts(Json& table, const Result& result);

  /// A row for each pair; of one that was given, or is the only one, every quantity.
  static std::string table(const problems::GearPairProblem& problem, const Result& result,
                           const Screen& screen);
  static std::string page(const problems::GearPairProblem& /*problem*/, const Result& /*result*/) {
    return gear_page();
  }
  static Json report_data(const problems::GearPairProblem& problem, const Result& result) {
    return gear_pair_report_data(problem, result);
  }
  static problems::MetricNames metric_names(const problems::GearPairProblem& base);
  static std::vector<ListSection> sections();
  static std::vector<MetricList> metric_lists();

  /// Designs of this type in result files are exported by `export_design`.
  static constexpr std::string_view kOwnType = "gear-pair";
  static ExportOutcome export_design(const ResultDesign& design, const ExportOptions& wanted,
                                     const std::string& stem);
};

/// The tables of `kind = "gear"` and of `kind = "gear-pair"` and their keys.
std::span<const KeyedEntry> gear_tables();
std::span<const KeyedEntry> gear_pair_tables();

/// Keys of the metrics of a gear, which a pair has of each of its gears under "pinion." and
/// "wheel.".
std::span<const Metric> gear_metrics();

/// Further keys of the metrics of a pair.
std::span<const Metric> gear_pair_metrics();

}  // namespace cognate::app
