#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/console/table.hpp"
#include "app/console/table_text.hpp"
#include "app/documents/result_json.hpp"
#include "app/kinds/cam/json.hpp"
#include "app/kinds/cam/table.hpp"
#include "app/kinds/gear/json.hpp"
#include "app/kinds/gear/table.hpp"
#include "app/report/report.hpp"
#include "app/study/problem_atlas.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

using problems::Status;

constexpr const char* kInterrupted = "interrupted; what was found until then is reported";

template <class AnyResult>
ExitStatus status_of(const AnyResult& result) {
  const bool stopped = result.status == Status::time_limit || result.status == Status::interrupted;
  const bool done = result.status == Status::solved || (stopped && feasible_count(result) > 0);
  return done ? exit_done : exit_no_design;
}

/// Solves, writes and prints a problem; `solve` and `table` are those of its kind.
template <class AnyResult, class AnyProblem, class Solve, class Table>
ExitStatus solve_with(const std::filesystem::path& file, const AnyProblem& problem,
                      const Options& options, Solve solve, Table table) {
  AnyResult result;
  return compute(
      file, options,
      {.run =
           [&](const problems::Run& run) {
             result = solve(run);
             return result.status;
           },
       .document = [&] { return result_document(problem, result, options.seed); },
       .files = {{".report.html",
                  [&](const auto& document) { return report_html(document, problem, result); }}},
       .when_interrupted = kInterrupted,
       .table = [&](const Screen& screen) { return table(problem, result, screen); },
       .exit_status = [&] { return status_of(result); }});
}

/// How many curves of an atlas a search begins with.
constexpr std::size_t kAtlasStarts = 48;

ExitStatus solve_linkage(const std::filesystem::path& file, const problems::Problem& problem,
                         const Options& options) {
  const auto curves = problem_atlas(problem);
  if (!curves) return refuse(file, curves.error());
  std::vector<problems::Design> known;
  if (!curves->empty()) {
    known = atlas_starts(std::get<problems::PathProblem>(problem), *curves, kAtlasStarts);
  }
  const auto solve = [&](problems::Run run) {
    run.known = known;
    auto result =
        std::visit([&](const auto& given) { return problems::solve(given, run); }, problem);
    if (!known.empty()) {
      result.notes.push_back(fmt::format(
          "The search began with {} curves of the atlas, besides its own starts.", known.size()));
    }
    return result;
  };
  return solve_with<problems::Result>(file, problem, options, solve, design_table);
}

ExitStatus solve_cam(const std::filesystem::path& file, const problems::CamProblem& problem,
                     const Options& options) {
  const auto solve = [&](const problems::Run& run) { return problems::solve(problem, run); };
  return solve_with<problems::CamResult>(file, problem, options, solve, cam_table);
}

ExitStatus solve_gear_pair(const std::filesystem::path& file,
                           const problems::GearPairProblem& problem, const Options& options) {
  const auto solve = [&](const problems::Run& run) { return problems::solve(problem, run); };
  return solve_with<problems::GearPairResult>(file, problem, options, solve, gear_pair_table);
}

}  // namespace

ExitStatus solve_command(const std::filesystem::path& file, const Options& options) {
  const auto task = problems::read_task(file);
  if (!task) return refuse(file, task.error());
  if (const auto* problem = std::get_if<problems::CamProblem>(&*task)) {
    return solve_cam(file, *problem, options);
  }
  if (const auto* problem = std::get_if<problems::Problem>(&*task)) {
    return solve_linkage(file, *problem, options);
  }
  if (const auto* problem = std::get_if<problems::GearPairProblem>(&*task)) {
    return solve_gear_pair(file, *problem, options);
  }
  return refuse(file, problems::read_problem(file).error());  // of an analysis: there is nothing
}

}  // namespace cognate::app
