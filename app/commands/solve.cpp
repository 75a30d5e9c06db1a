#include <nlohmann/json.hpp>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/commands/task_computation.hpp"
#include "app/console/messages.hpp"
#include "app/export/exported.hpp"
#include "app/export/toml_text.hpp"
#include "app/kinds/kinds.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

/// Whether mechanisms of `type` are no linkages.
bool is_own_type(const std::string& type) {
  bool found = false;
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    if constexpr (requires { Kind<Problem>::kOwnType; }) found |= Kind<Problem>::kOwnType == type;
  });
  return found;
}

ExitStatus run(Command command, const fs::path& file, const Options& options) {
  const auto computation = file_computation(command, file, options);
  return computation ? compute(file, options, *computation) : computation.error();
}

}  // namespace

tl::expected<Computation, ExitStatus> file_computation(Command command, const fs::path& file,
                                                       const Options& options) {
  const auto refused = [&](const std::vector<problems::Fault>& faults) {
    return tl::unexpected(refuse(file, faults, options));
  };
  auto read = problems::read_task_at(file, options.length_unit);
  if (!read) return refused(read.error());
  const std::string why = task_refusal(read->task, command);
  if (!why.empty()) return refused({{read->line, read->column, why}});
  if (options.steps && !has_steps(read->task)) {
    complain("--steps: divides the turn of a cam; remove it for other kinds of problem");
    return tl::unexpected(exit_bad_input);
  }
  auto computation = task_computation(std::move(read->task), options);
  if (!computation) return refused(computation.error());
  return std::move(*computation);
}

ExitStatus solve_command(const fs::path& file, const Options& options) {
  return run(Command::solve, file, options);
}

ExitStatus analyze_command(const fs::path& file, const Options& options) {
  return run(Command::analyze, file, options);
}

ExitStatus analyze_design_command(const fs::path& file, int design, const Options& options) {
  const auto refuse_file = [&](const std::string& message) {
    return refuse_result(file, message, options);
  };
  const auto given = read_result_design(file, design).and_then([&](ResultDesign read) {
    return in_length_unit(std::move(read), options.length_unit);
  });
  if (!given) return refuse_file(given.error());
  if (const std::string type = text_under(given->table["mechanism"], "type"); is_own_type(type)) {
    return refuse_file(file.string() + ": is the result of a " + type +
                       "; expected that of a linkage");
  }
  const auto tables = analysis_of_design(*given);
  if (!tables) return refuse_file(tables.error());
  auto problem = problems::parse_task<problems::AnalysisProblem>(toml_text(*tables));
  if (!problem) return refuse(file, problem.error(), options);
  const auto computation = task_computation(std::move(*problem), options);
  if (!computation) return refuse(file, computation.error(), options);
  const fs::path named = design_stem(stem_of_result(file), design) + ".toml";
  return compute(named, options, *computation);
}

}  // namespace cognate::app
