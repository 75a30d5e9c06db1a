#include <nlohmann/json.hpp>
#include <variant>

#include "app/analysis_json.hpp"
#include "app/analysis_table.hpp"
#include "app/commands.hpp"
#include "app/computation.hpp"
#include "app/csv.hpp"
#include "app/machine_json.hpp"
#include "app/machine_table.hpp"
#include "app/report/report.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

ExitStatus analyze(const fs::path& file, const problems::AnalysisProblem& problem,
                   const Options& options) {
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
       .when_interrupted = "interrupted; what was computed until then is reported",
       .table = [&](const Screen& screen) { return analysis_table(problem, result, screen); },
       .exit_status = [&] { return result.closed_rows > 0 ? exit_done : exit_no_design; }});
}

ExitStatus analyze(const fs::path& file, const problems::MachineProblem& problem,
                   const Options& options) {
  problems::MachineResult result;
  const auto run_it = [&](const problems::Run& run) {
    result = problems::run_machine(problem, run);
    return result.status;
  };
  return compute(
      file, options,
      {.run = run_it,
       .document = [&] { return result_document(problem, result, options.seed); },
       .files = {{".csv", [&](const auto&) { return machine_csv(result); }},
                 {".report.html",
                  [&](const auto& document) { return report_html(document, problem, result); }}},
       .when_interrupted = "interrupted; the motions found until then are reported",
       .table = [&](const Screen& screen) { return machine_table(problem, result, screen); },
       .exit_status =
           [&] { return result.status == problems::Status::solved ? exit_done : exit_no_design; }});
}

}  // namespace

ExitStatus analyze_command(const fs::path& file, const Options& options) {
  const auto task = problems::read_task(file);
  if (!task) return refuse(file, task.error());
  if (const auto* machine = std::get_if<problems::MachineProblem>(&*task)) {
    return analyze(file, *machine, options);
  }
  const auto problem = problems::read_analysis(file);
  return problem ? analyze(file, *problem, options) : refuse(file, problem.error());
}

}  // namespace cognate::app
