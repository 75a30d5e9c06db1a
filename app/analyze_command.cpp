#include <nlohmann/json.hpp>

#include "app/analysis_json.hpp"
#include "app/analysis_table.hpp"
#include "app/commands.hpp"
#include "app/computation.hpp"
#include "app/csv.hpp"
#include "app/gear_json.hpp"
#include "app/gear_table.hpp"
#include "app/report/report.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

constexpr const char* kInterrupted = "interrupted; what was computed until then is reported";

ExitStatus analyze_mechanism(const std::filesystem::path& file,
                             const problems::AnalysisProblem& problem, const Options& options) {
  problems::AnalysisResult result;
  const auto analyse = [&](const problems::Run& run) {
    result = problems::analyse(problem, run);
    return result.status;
  };
  return compute(
      file, options,
      {.run = analyse,
       .document = [&] { return result_document(problem, result, options.seed); },
       .files = {{".csv", [&](const auto&) { return csv_text(result.columns); }},
                 {".report.html",
                  [&](const auto& document) { return report_html(document, problem, result); }}},
       .when_interrupted = kInterrupted,
       .table = [&](const Screen& screen) { return analysis_table(problem, result, screen); },
       .exit_status = [&] { return result.closed_rows > 0 ? exit_done : exit_no_design; }});
}

ExitStatus analyze_gear(const std::filesystem::path& file, const problems::GearProblem& problem,
                        const Options& options) {
  problems::GearResult result;
  const auto analyse = [&](const problems::Run& run) {
    result = problems::analyse(problem, run);
    return result.status;
  };
  return compute(
      file, options,
      {.run = analyse,
       .document = [&] { return result_document(problem, result, options.seed); },
       .files = {{".csv", [&](const auto&) { return csv_text(result.columns); }},
                 {".report.html",
                  [&](const auto& document) { return report_html(document, problem, result); }}},
       .when_interrupted = kInterrupted,
       .table = [&](const Screen& screen) { return gear_table(problem, result, screen); },
       .exit_status =
           [&] { return result.status == problems::Status::solved ? exit_done : exit_no_design; }});
}

ExitStatus analyze_gear_pair(const std::filesystem::path& file,
                             const problems::GearPairProblem& problem, const Options& options) {
  if (!is_whole(problem)) {
    return refuse(file, {{1, 1,
                          "the gear pair is not whole; teeth, module and both values of "
                          "profile_shift are wanted, or 'cognate solve', which finds them"}});
  }
  problems::GearPairResult result;
  const auto solve = [&](const problems::Run& run) {
    result = problems::solve(problem, run);
    return result.status;
  };
  return compute(
      file, options,
      {.run = solve,
       .document = [&] { return result_document(problem, result, options.seed); },
       .files = {{".report.html",
                  [&](const auto& document) { return report_html(document, problem, result); }}},
       .when_interrupted = kInterrupted,
       .table = [&](const Screen& screen) { return gear_pair_table(problem, result, screen); },
       .exit_status =
           [&] { return result.status == problems::Status::solved ? exit_done : exit_no_design; }});
}

}  // namespace

ExitStatus analyze_command(const std::filesystem::path& file, const Options& options) {
  const auto task = problems::read_task(file);
  if (!task) return refuse(file, task.error());
  if (const auto* problem = std::get_if<problems::AnalysisProblem>(&*task)) {
    return analyze_mechanism(file, *problem, options);
  }
  if (const auto* problem = std::get_if<problems::GearProblem>(&*task)) {
    return analyze_gear(file, *problem, options);
  }
  if (const auto* problem = std::get_if<problems::GearPairProblem>(&*task)) {
    return analyze_gear_pair(file, *problem, options);
  }
  return refuse(file, problems::read_analysis(file).error());  // of a design: it is to be solved
}

}  // namespace cognate::app
