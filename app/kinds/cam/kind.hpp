/// @file What the program does with `kind = "cam"`.
#pragma once

#include "app/export/exported.hpp"
#include "app/kinds/basics/kind.hpp"
#include "app/report/cam_report_data.hpp"
#include "app/report/page.hpp"
#include "problems/cam/result.hpp"

namespace cognate::app {

template <>
struct Kind<problems::CamProblem> : KindBase<problems::CamProblem, problems::CamResult> {
  static constexpr std::string_view kMeaning =
      "a follower moves by given laws over a turn of a cam";
  static std::string refusal(const problems::CamProblem& problem, Command command);
  static Result run(const problems::CamProblem& problem, const problems::Run& run) {
    return problems::solve(problem, run);
  }

  /// The title, the follower, the motion, and what of them is free.
  static std::string describe(const problems::CamProblem& problem);

  /// `mechanism` is a table of type "cam" that alone gives the design's cam, `crank_deg` empty and
  /// `error` 0, since a profile gives its motion exactly; and `proof` of the size.
  static Json design_json(const problems::CamProblem& problem, const Result& result,
                          std::size_t index);

  /// What was found on a raster.
  static void add_facts(Json& table, const Result& result);

  /// `segments` and `jumps` of the motion.
  static void add_findings(Json& document, const problems::CamProblem& problem,
                           const Result& result);

  /// A heading, the status in words, one row for each of the first 20 designs (number, lengths,
  /// greatest pressure angles of rise and return and least convex radius of curvature, each with
  /// the cam angle of its place, constraints, origin), then what a design violates, what proves the
  /// size of the best one, the notes, and the time. Angles are in degrees.
  static std::string table(const problems::CamProblem& problem, const Result& result,
                           const Screen& screen);
  /// The best design over a turn, in `steps` equal steps of the cam angle.
  static std::string csv(const problems::CamProblem& problem, const Result& result, int steps);
  static std::string page(const problems::CamProblem& /*problem*/, const Result& /*result*/) {
    return cam_page();
  }
  static Json report_data(const problems::CamProblem& problem, const Result& result) {
    return cam_report_data(problem, result);
  }
  static problems::MetricNames metric_names(const problems::CamProblem& base);
  static std::vector<ListSection> sections();
  static std::vector<MetricList> metric_lists();

  /// Designs of this type in result files are exported by `export_design`.
  static constexpr std::string_view kOwnType = "cam";
  static ExportOutcome export_design(const ResultDesign& design, const ExportOptions& wanted,
                                     const std::string& stem);
};

/// The values of `follower.type`, each with the keys of lengths that it has.
std::span<const KeyedEntry> cam_followers();

/// Keys of the metrics of a cam other than those of all designs.
std::span<const Metric> cam_metrics();

}  // namespace cognate::app
