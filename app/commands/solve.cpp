#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/export/exported.hpp"
#include "app/export/toml_text.hpp"
#include "app/kinds/kinds.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

/// Of a cam's table over its turn.
constexpr int kTurnSteps = 360;

template <class K, class Problem>
constexpr bool has_turn_table = requires(const Problem& problem, const typename K::Result& result) {
  K::csv(problem, result, kTurnSteps);
};

/// The files of a result besides the document.
template <class K, class Problem>
std::vector<OutputFile> files_of(const Problem& problem, const typename K::Result& result,
                                 const Options& options) {
  std::vector<OutputFile> files;
  if constexpr (requires { K::csv(problem, result); }) {
    files.push_back({".csv", [&](const auto&) { return K::csv(problem, result); }});
  } else if constexpr (has_turn_table<K, Problem>) {
    const int steps = options.steps.value_or(kTurnSteps);
    files.push_back({".csv", [&, steps](const auto&) { return K::csv(problem, result, steps); }});
  }
  files.push_back({".report.html",
                   [&](const auto& document) { return report_html(document, problem, result); }});
  return files;
}

/// Computes what `problem`, read from `file`, asks for, writes and prints it.
template <class K, class Problem>
ExitStatus compute_problem(const fs::path& file, const Problem& problem, const Options& options) {
  if (options.steps && !has_turn_table<K, Problem>) {
    complain("--steps: divides the turn of a cam; remove it for other kinds of problem");
    return exit_bad_input;
  }
  const auto known = K::known_designs(problem);
  if (!known) return refuse(file, known.error(), options);
  typename K::Result result;
  return compute(file, options,
                 {.run =
                      [&](problems::Run run) {
                        run.known = *known;
                        result = K::run(problem, run);
                        return result.status;
                      },
                  .document = [&] { return result_document(problem, result, options.seed); },
                  .files = files_of<K>(problem, result, options),
                  .when_interrupted = K::kWhenInterrupted,
                  .table =
                      [&](Screen screen) {
                        screen.length = length_word(problem.length_unit);
                        return K::table(problem, result, screen);
                      },
                  .exit_status = [&] { return K::is_done(result) ? exit_done : exit_no_design; }});
}

/// Whether mechanisms of `type` are no linkages.
bool is_own_type(const std::string& type) {
  bool found = false;
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    if constexpr (requires { Kind<Problem>::kOwnType; }) found |= Kind<Problem>::kOwnType == type;
  });
  return found;
}

ExitStatus run(Command command, const fs::path& file, const Options& options) {
  const auto read = problems::read_task_at(file, options.length_unit);
  if (!read) return refuse(file, read.error(), options);
  return visit_kind(read->task, [&]<class K>(K, const auto& problem) {
    const std::string why = K::refusal(problem, command);
    return why.empty() ? compute_problem<K>(file, problem, options)
                       : refuse(file, {{read->line, read->column, why}}, options);
  });
}

}  // namespace

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
  const auto problem = problems::parse_task<problems::AnalysisProblem>(toml_text(*tables));
  if (!problem) return refuse(file, problem.error(), options);
  const fs::path named = design_stem(stem_of_result(file), design) + ".toml";
  return compute_problem<Kind<problems::AnalysisProblem>>(named, *problem, options);
}

}  // namespace cognate::app
