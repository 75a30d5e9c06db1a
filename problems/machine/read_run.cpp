#include "problems/machine/read_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "problems/basics/names.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kTasks = "tasks";

constexpr NumberRule kTime{is_positive_quantity, "a time from 1e-30 to 1e30 seconds"};
constexpr NumberRule kTurns{[](double x) { return x >= 1e-6 && x <= 1e6; },
                            "a number of turns from 1e-6 to 1e6"};
constexpr NumberRule kSpeed{[](double x) { return x >= 0 && is_quantity(x); },
                            "a speed in rad/s, 0 or from 1e-30 to 1e30,"};
constexpr NumberRule kRelative{[](double x) { return x >= 1e-13 && x <= 1e-3; },
                               "a relative tolerance from 1e-13 to 1e-3"};
constexpr int kFewestSteps = 12;
constexpr int kMostSteps = 100'000;

std::optional<MachineTask> task_named(std::string_view word) {
  for (const auto& [name, task] : names<MachineTask>()) {
    if (name == word) return task;
  }
  return std::nullopt;
}

std::vector<MachineTask> read_tasks(TableReader& run) {
  std::vector<MachineTask> tasks;
  if (!run.has(kTasks)) return {MachineTask::steady};
  const auto words = run.texts(kTasks, {1, std::size(names<MachineTask>()), "tasks"});
  if (!words) return tasks;
  std::vector<std::string_view> allowed;
  for (const auto& named : names<MachineTask>()) allowed.push_back(named.name);
  for (std::size_t i = 0; i < words->size(); ++i) {
    const auto task = task_named((*words)[i]);
    if (!task) {
      const auto meant = nearest((*words)[i], allowed);
      run.faults().add(
          run.where(kTasks, i),
          fmt::format("entry {} of {} is {}{}; allowed are {}", i + 1, run.name(kTasks),
                      in_quotes((*words)[i]), meant ? ", perhaps for " + in_quotes(*meant) : "",
                      quoted_list(allowed)));
    } else if (std::ranges::find(tasks, *task) != tasks.end()) {
      run.faults().add(run.where(kTasks, i),
                       fmt::format("entry {} of {} is {} again; each task once is wanted", i + 1,
                                   run.name(kTasks), in_quotes((*words)[i])));
    } else {
      tasks.push_back(*task);
    }
  }
  return tasks;
}

}  // namespace

bool asks_for(const MachineRunRequest& run, MachineTask task) {
  return std::ranges::find(run.tasks, task) != run.tasks.end();
}

MachineRunRequest read_run(TableReader& table) {
  MachineRunRequest run;
  run.tasks = read_tasks(table);
  run.start_phi = radians(table.number("start_deg", kAngle).value_or(0));
  run.start_speed = table.number("start_speed", kSpeed).value_or(0);
  run.time_max = table.number("time_max", kTime);
  run.turns_max = table.number("turns_max", kTurns);
  run.speed_end = table.number("speed_end", kSpeed);
  run.steps = table.integer("steps", kFewestSteps, kMostSteps).value_or(run.steps);
  run.tolerance = table.number("tolerance", kRelative).value_or(run.tolerance);
  table.finish();
  return run;
}

}  // namespace cognate::problems::reading
