#include <nlohmann/json.hpp>

#include "app/analysis_json.hpp"
#include "app/analysis_table.hpp"
#include "app/commands.hpp"
#include "app/computation.hpp"
#include "app/csv.hpp"
#include "app/report/report.hpp"
#include "problems/read.hpp"

namespace cognate::app {

ExitStatus analyze_command(const std::filesystem::path& file, const Options& options) {
  const auto problem = problems::read_analysis(file);
  if (!problem) return refuse(file, problem.error());
  problems::AnalysisResult result;
  const auto analyse = [&](const problems::Run& run) {
    result = problems::analyse(*problem, run);
    return result.status;
  };
  return compute(
      file, options,
      {.run = analyse,
       .document = [&] { return result_document(*problem, result, options.seed); },
       .files = {{".csv", [&](const auto&) { return csv_text(result.columns); }},
                 {".report.html",
                  [&](const auto& document) { return report_html(document, *problem, result); }}},
       .when_interrupted = "interrupted; what was computed until then is reported",
       .table = [&](const Screen& screen) { return analysis_table(*problem, result, screen); },
       .exit_status = [&] { return result.closed_rows > 0 ? exit_done : exit_no_design; }});
}

}  // namespace cognate::app
