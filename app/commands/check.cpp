#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <variant>

#include "app/commands/commands.hpp"
#include "app/console/messages.hpp"
#include "app/console/table.hpp"
#include "app/console/terminal.hpp"
#include "app/documents/problem_json.hpp"
#include "app/documents/result_json.hpp"
#include "app/kinds/cam/description.hpp"
#include "app/kinds/evaluation/problem_json.hpp"
#include "app/kinds/evaluation/table.hpp"
#include "app/kinds/gear/description.hpp"
#include "app/kinds/machine/json.hpp"
#include "app/kinds/machine/table.hpp"
#include "app/study/metrics.hpp"
#include "app/study/problem_atlas.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

ordered_json faults_json(const std::vector<problems::Fault>& faults) {
  ordered_json rows = ordered_json::array();
  for (const auto& fault : faults) {
    rows.push_back({{"line", fault.line}, {"column", fault.column}, {"message", fault.message}});
  }
  return rows;
}

/// The same, or what keeps the file that a problem names from being an atlas.
tl::expected<problems::TaskOrStudy, std::vector<problems::Fault>> with_sound_atlas(
    problems::TaskOrStudy read) {
  const auto* const task = std::get_if<problems::Task>(&read);
  const auto* const problem = task ? std::get_if<problems::Problem>(task) : nullptr;
  if (problem) {
    if (const auto atlas = problem_atlas(*problem); !atlas) return tl::unexpected(atlas.error());
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
    return std::visit([](const auto& asked) { return describe(asked); }, task);
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
    return std::visit([](const auto& asked) { return to_json(asked); }, task);
  }
};

}  // namespace

ExitStatus check_command(const std::filesystem::path& file, const Options& options) {
  const auto read = problems::read_task_or_study(file, study_metrics).and_then(with_sound_atlas);
  if (!read) write_standard_error(fault_lines(file, read.error()));

  ExitStatus printed = exit_done;
  if (options.json) {
    ordered_json document = {
        {"format", "cognate-check/1"}, {"file", file.string()}, {"valid", read.has_value()}};
    if (read) document["problem"] = std::visit(AsJson{}, *read);
    document["faults"] = read ? ordered_json::array() : faults_json(read.error());
    printed = print(write_json(document));
  } else if (read && !options.quiet) {
    const std::string what = std::visit(Description{}, *read);
    const auto line = printable(file.string() + ": " + what + "; no fault found") + '\n';
    printed = print(fitted(line, standard_output()));
  }
  return read ? printed : exit_bad_input;
}

}  // namespace cognate::app
