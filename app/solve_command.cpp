#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/computation.hpp"
#include "app/report/report.hpp"
#include "app/result_json.hpp"
#include "app/table.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

using problems::Result;
using problems::Status;

ExitStatus status_of(const Result& result) {
  const bool stopped = result.status == Status::time_limit || result.status == Status::interrupted;
  const bool done = result.status == Status::solved || (stopped && feasible_count(result) > 0);
  return done ? exit_done : exit_no_design;
}

}  // namespace

ExitStatus solve_command(const std::filesystem::path& file, const Options& options) {
  const auto problem = problems::read_problem(file);
  if (!problem) return refuse(file, problem.error());
  Result result;
  const auto solve = [&](const problems::Run& run) {
    result = std::visit([&](const auto& given) { return problems::solve(given, run); }, *problem);
    return result.status;
  };
  return compute(
      file, options,
      {.run = solve,
       .document = [&] { return result_document(*problem, result, options.seed); },
       .files = {{".report.html",
                  [&](const auto& document) { return report_html(document, *problem, result); }}},
       .when_interrupted = "interrupted; what was found until then is reported",
       .table = [&](bool colour) { return design_table(*problem, result, colour); },
       .exit_status = [&] { return status_of(result); }});
}

}  // namespace cognate::app
