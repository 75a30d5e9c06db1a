#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

#include "app/console/messages.hpp"
#include "app/console/paint.hpp"
#include "app/console/table_text.hpp"
#include "app/documents/csv.hpp"
#include "app/kinds/basics/quantity_table.hpp"
#include "app/kinds/machine/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using problems::MachineProblem;
using problems::MachineResult;
using problems::Status;

std::string drive_words(const MachineProblem& problem) {
  if (!problem.motor) return "without a motor";
  const std::string train = problem.motor->train ? " and a gear train" : "";
  if (problem.motor->line) return "with a motor of a straight line" + train;
  return (problem.motor->torque.of_speed ? "with a motor whose torque depends on its speed"
                                         : "with a motor") +
         train;
}

std::string flywheel_words(const MachineProblem& problem) {
  if (problem.fluctuation) {
    return fmt::format(", a flywheel to be found for a fluctuation of {:.6g}",
                       *problem.fluctuation);
  }
  return problem.flywheel > 0 ? fmt::format(", a flywheel of {:.6g} kg m2", problem.flywheel) : "";
}

std::string status_words(const MachineResult& result) {
  switch (result.status) {
    case Status::solved:
      return "solved: every motion requested exists";
    case Status::infeasible:
      return "not every motion requested exists, or ends as it should";
    case Status::time_limit:
      return "stopped at the time limit";
    case Status::interrupted:
      return "interrupted";
    default:
      return "no solution: no motion requested exists";
  }
}

Colour colour_of(const MachineResult& result) {
  if (result.status == Status::solved) return Colour::green;
  return result.motions.empty() ? Colour::red : Colour::yellow;
}

std::size_t rows_of(const problems::MachineMotion& motion) {
  return motion.columns.empty() ? 0 : motion.columns.front().values.size();
}

}  // namespace

std::string Kind<MachineProblem>::refusal(const MachineProblem& /*problem*/, Command command) {
  if (command == Command::analyze) return "";
  return "kind is \"machine\": there is nothing to solve, 'cognate analyze' runs this machine; "
         "expected a design problem";
}

std::string Kind<MachineProblem>::describe(const MachineProblem& problem) {
  std::vector<std::string_view> tasks;
  for (const auto task : problem.run.tasks) tasks.push_back(problems::to_string(task));
  const std::string_view moving = problem.mechanism
                                      ? problems::to_string(problem.mechanism->mechanism.type())
                                      : "equivalent inertia";
  const auto what = fmt::format("machine of {} {}{}: {}", moving, drive_words(problem),
                                flywheel_words(problem), fmt::join(tasks, ", "));
  return titled(problem.title, what);
}

std::string Kind<MachineProblem>::table(const MachineProblem& problem, const MachineResult& result,
                                        const Screen& screen) {
  std::string text = describe(problem) + '\n';
  text += paint(status_words(result), colour_of(result), screen.colour) + '\n';
  text += quantity_table(result.quantities, screen);
  text += '\n';
  text += notes_text(result.notes);
  return text + work_line(result.work);
}

std::string Kind<MachineProblem>::csv(const MachineProblem& problem, const MachineResult& result) {
  if (result.motions.empty()) return csv_text({});
  std::vector<std::string> tasks;
  std::vector<problems::Column> columns = result.motions.front().columns;
  for (auto& column : columns) column.values.clear();
  for (const auto& motion : result.motions) {
    tasks.insert(tasks.end(), rows_of(motion), std::string(problems::to_string(motion.task)));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto& values = motion.columns[i].values;
      columns[i].values.insert(columns[i].values.end(), values.begin(), values.end());
    }
  }
  return csv_text(columns, {"task", tasks}, length_word(problem.length_unit));
}

}  // namespace cognate::app
