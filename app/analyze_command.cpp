#include <nlohmann/json.hpp>
#include <variant>

#include "app/analysis_json.hpp"
#include "app/analysis_table.hpp"
#include "app/commands.hpp"
#include "app/computation.hpp"
#include "app/csv.hpp"
#include "app/gear_json.hpp"
#include "app/gear_table.hpp"
#include "app/machine_json.hpp"
#include "app/machine_table.hpp"
#include "app/report/report.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInterrupted = "interrupted; what was computed until then is reported";

ExitStatus status_of(problems::Status status) {
  return status == problems::Status::solved ? exit_done : exit_no_design;
}

/// Analyses what the file holds, by its kind.
struct Analyze {
  const fs::path& file;
  const Options& options;

  ExitStatus operator()(const problems::AnalysisProblem& problem) const {
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

  ExitStatus operator()(const problems::GearProblem& problem) const {
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
         .exit_status = [&] { return status_of(result.status); }});
  }

  ExitStatus operator()(const problems::GearPairProblem& problem) const {
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
         .exit_status = [&] { return status_of(result.status); }});
  }

  ExitStatus operator()(const problems::MachineProblem& problem) const {
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
         .exit_status = [&] { return status_of(result.status); }});
  }

  /// Of a design: it is to be solved.
  template <class Design>
  ExitStatus operator()(const Design&) const {
    return refuse(file, problems::read_analysis(file).error());
  }
};

}  // namespace

ExitStatus analyze_command(const fs::path& file, const Options& options) {
  const auto task = problems::read_task(file);
  return task ? std::visit(Analyze{file, options}, *task) : refuse(file, task.error());
}

}  // namespace cognate::app
