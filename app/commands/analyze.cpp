#include <nlohmann/json.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/documents/csv.hpp"
#include "app/kinds/evaluation/json.hpp"
#include "app/kinds/evaluation/table.hpp"
#include "app/kinds/gear/json.hpp"
#include "app/kinds/gear/table.hpp"
#include "app/kinds/machine/json.hpp"
#include "app/kinds/machine/table.hpp"
#include "app/report/report.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

/// How a kind of problem is analysed, and told of.
template <class Problem, class Result>
struct Analysis {
  Result (*analyse)(const Problem&, const problems::Run&);
  std::string (*table)(const Problem&, const Result&, const Screen&);
  std::string (*csv)(const Result&) = nullptr;  ///< none where there is no table of numbers
  const char* when_interrupted = "interrupted; what was computed until then is reported";
  ExitStatus (*exit_status)(const Result&) = [](const Result& result) {
    return result.status == problems::Status::solved ? exit_done : exit_no_design;
  };
};

/// Analyses what the file holds, by its kind.
struct Analyze {
  const fs::path& file;
  const Options& options;

  ExitStatus operator()(const problems::AnalysisProblem& problem) const {
    return run<problems::AnalysisResult>(
        problem, {.analyse = problems::analyse,
                  .table = analysis_table,
                  .csv = [](const auto& result) { return csv_text(result.columns); },
                  .exit_status =
                      [](const auto& result) {
                        return result.closed_rows > 0 ? exit_done : exit_no_design;
                      }});
  }

  ExitStatus operator()(const problems::GearProblem& problem) const {
    return run<problems::GearResult>(
        problem, {.analyse = problems::analyse, .table = gear_table, .csv = [](const auto& result) {
                    return csv_text(result.columns);
                  }});
  }

  ExitStatus operator()(const problems::GearPairProblem& problem) const {
    if (!is_whole(problem)) {
      return refuse(file, {{1, 1,
                            "the gear pair is not whole; teeth, module and both values of "
                            "profile_shift are wanted, or 'cognate solve', which finds them"}});
    }
    return run<problems::GearPairResult>(problem,
                                         {.analyse = problems::solve, .table = gear_pair_table});
  }

  ExitStatus operator()(const problems::MachineProblem& problem) const {
    return run<problems::MachineResult>(
        problem, {.analyse = problems::run_machine,
                  .table = machine_table,
                  .csv = machine_csv,
                  .when_interrupted = "interrupted; the motions found until then are reported"});
  }

  /// Of a design: it is to be solved.
  template <class Design>
  ExitStatus operator()(const Design&) const {
    return refuse(file, problems::read_analysis(file).error());
  }

 private:
  template <class Result, class Problem>
  ExitStatus run(const Problem& problem, const Analysis<Problem, Result>& analysis) const {
    Result result;
    std::vector<OutputFile> files;
    if (analysis.csv) {
      files.push_back({".csv", [&](const auto&) { return analysis.csv(result); }});
    }
    files.push_back({".report.html",
                     [&](const auto& document) { return report_html(document, problem, result); }});
    return compute(
        file, options,
        {.run =
             [&](const problems::Run& run) {
               result = analysis.analyse(problem, run);
               return result.status;
             },
         .document = [&] { return result_document(problem, result, options.seed); },
         .files = std::move(files),
         .when_interrupted = analysis.when_interrupted,
         .table = [&](const Screen& screen) { return analysis.table(problem, result, screen); },
         .exit_status = [&] { return analysis.exit_status(result); }});
  }
};

}  // namespace

ExitStatus analyze_command(const fs::path& file, const Options& options) {
  const auto task = problems::read_task(file);
  return task ? std::visit(Analyze{file, options}, *task) : refuse(file, task.error());
}

}  // namespace cognate::app
