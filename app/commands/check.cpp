#include <nlohmann/json.hpp>
#include <variant>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/commands/problem_text.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/kinds/kinds.hpp"
#include "app/study/metrics.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

struct AsJson {
  ordered_json operator()(const problems::Study& study) const {
    ordered_json variables = ordered_json::array();
    for (const auto& variable : study.variables) variables.push_back(variable.key);
    return {{"kind", "study"},        {"title", study.title},
            {"base", study.base},     {"designs", problems::design_count(study)},
            {"variables", variables}, {"metrics", study.metrics}};
  }
  ordered_json operator()(const problems::Task& task) const {
    return std::visit([](const auto& problem) { return problem_json(problem); }, task);
  }
};

}  // namespace

ExitStatus check_command(const std::filesystem::path& file, const Options& options) {
  const auto read = problems::read_task_or_study(file, study_metrics).and_then(with_sound_files);
  if (!read) return refuse(file, read.error(), options);
  if (options.json) {
    return print(write_json({{"format", "cognate-check/1"},
                             {"file", file.string()},
                             {"valid", true},
                             {"problem", std::visit(AsJson{}, *read)},
                             {"faults", ordered_json::array()}}));
  }
  if (options.quiet) return exit_done;
  const std::string what = description(*read);
  const auto line = printable(file.string() + ": " + what + "; no fault found") + '\n';
  return print(fitted(line, standard_output()));
}

}  // namespace cognate::app
