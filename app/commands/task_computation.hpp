/// @file The computation that a problem asks for, whatever its kind.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/commands/computation.hpp"
#include "app/console/options.hpp"
#include "app/kinds/basics/command.hpp"
#include "problems/read.hpp"

namespace cognate::app {

/// The ending of a report page's file behind the stem of its problem's.
inline constexpr const char* kReportEnding = ".report.html";

/// What computes what `task` asks for, which it keeps, with the seed and the steps of `options`; or
/// what is wrong with the files that the task names.
tl::expected<Computation, std::vector<problems::Fault>> task_computation(problems::Task task,
                                                                         const Options& options);

/// The computation that `command` makes of `file`; or the status, once every fault has been said.
tl::expected<Computation, ExitStatus> file_computation(Command command,
                                                       const std::filesystem::path& file,
                                                       const Options& options);

/// Why `command` does not take `task`; empty where it does.
std::string task_refusal(const problems::Task& task, Command command);

/// Whether `task` has a table over a turn, which is divided into steps.
bool has_steps(const problems::Task& task);

}  // namespace cognate::app
