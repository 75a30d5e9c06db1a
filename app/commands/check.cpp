#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/kinds/kinds.hpp"
#include "app/study/metrics.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// The same, or what is wrong with a file that it names.
tl::expected<problems::TaskOrStudy, std::vector<problems::Fault>> with_sound_files(
    problems::TaskOrStudy read) {
  if (const auto* task = std::get_if<problems::Task>(&read)) {
    auto faults =
        visit_kind(*task, [](auto kind, const auto& problem) { return kind.faults(problem); });
    if (!faults.empty()) return tl::unexpected(std::move(faults));
  }
  return read;
}

struct Description {
  std::string operator()(const problems::Study& study) const {
    const auto plural = [](std::int64_t count, const char* of) {
      return fmt::format("{} {}{}", count, of, count == 1 ? "" : "s");
    };
    return fmt::format("a study of {}: {}, {}, {}", study.base,
                       plural(problems::design_count(study), "design"),
                       plural(std::ssize(study.variables), "variable"),
                       plural(std::ssize(study.metrics), "metric"));
  }
  std::string operator()(const problems::Task& task) const {
    return visit_kind(task, [](auto kind, const auto& problem) { return kind.describe(problem); });
  }
};

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
  const std::string what = std::visit(Description{}, *read);
  const auto line = printable(file.string() + ": " + what + "; no fault found") + '\n';
  return print(fitted(line, standard_output()));
}

}  // namespace cognate::app
