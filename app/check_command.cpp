#include <nlohmann/json.hpp>
#include <variant>

#include "app/analysis_problem_json.hpp"
#include "app/analysis_table.hpp"
#include "app/cam_description.hpp"
#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/problem_json.hpp"
#include "app/result_json.hpp"
#include "app/table.hpp"
#include "app/terminal.hpp"
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

std::string described(const problems::Task& task) {
  return std::visit([](const auto& asked) { return describe(asked); }, task);
}

ordered_json task_json(const problems::Task& task) {
  return std::visit([](const auto& asked) { return to_json(asked); }, task);
}

}  // namespace

ExitStatus check_command(const std::filesystem::path& file, const Options& options) {
  const auto task = problems::read_task(file);
  if (!task) write_standard_error(fault_lines(file, task.error()));

  ExitStatus printed = exit_done;
  if (options.json) {
    ordered_json document = {
        {"format", "cognate-check/1"}, {"file", file.string()}, {"valid", task.has_value()}};
    if (task) document["problem"] = task_json(*task);
    document["faults"] = task ? ordered_json::array() : faults_json(task.error());
    printed = print(write_json(document));
  } else if (task && !options.quiet) {
    printed = print(printable(file.string() + ": " + described(*task) + "; no fault found") + '\n');
  }
  return task ? printed : exit_bad_input;
}

}  // namespace cognate::app
