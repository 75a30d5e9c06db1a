/// @file The program `cognate`: its command line and its exit status.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "app/commands/command_line_faults.hpp"
#include "app/commands/commands.hpp"
#include "app/console/interrupt.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/documents/version.hpp"
#include "app/export/result_document.hpp"
#include "app/kinds/kinds.hpp"
#include "app/shell/completion.hpp"
#include "app/shell/manual_page.hpp"
#include "app/studio/studio.hpp"
#include "app/study/columns.hpp"
#include "app/study/processes.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

/// Copies `parsed` to `value`, or says what is wrong with it.
template <class Parsed, class Value>
bool take(const Parsed& parsed, Value& value) {
  if (parsed) {
    value = *parsed;
  } else {
    complain(parsed.error());
  }
  return parsed.has_value();
}

/// The options in `arguments`; empty, once every fault has been said, where one is not allowed.
std::optional<Options> options_of(const CLI::App& app, const Arguments& arguments) {
  const auto counts_in = [](const CLI::App& where, const char* name) {
    const auto* option = where.get_option_no_throw(name);
    return option != nullptr && option->count() > 0;
  };
  const auto given = [&](const char* name) {
    return counts_in(app, name) || counts_in(*app.get_subcommands().front(), name);
  };
  Options options{.json = arguments.json, .quiet = arguments.quiet};
  bool allowed = true;
  if (given("--seed")) allowed &= take(parse_seed(arguments.seed), options.seed);
  if (given("--threads")) allowed &= take(parse_threads(arguments.threads), options.threads);
  if (given("--time-limit")) {
    allowed &= take(parse_time_limit(arguments.time_limit), options.time_limit);
  }
  const bool solves = app.get_subcommands().front()->get_name() == "solve";
  if (solves && given("--steps")) {
    allowed &= take(parse_steps(arguments.steps), options.steps.emplace());
  }
  if (given("--length-unit")) {
    allowed &= take(parse_length_unit(arguments.length_unit), options.length_unit);
  }
  if (given("--out")) allowed &= take(parse_folder(arguments.out), options.out);
  return allowed ? std::optional(options) : std::nullopt;
}

/// The command that makes a result of `file`: `analyze` of what a file gives whole.
const char* command_for(const std::string& file) {
  const auto task = problems::read_task(file);
  if (!task) return "solve";
  return visit_kind(*task, [](auto kind, const auto& problem) {
    return kind.refusal(problem, Command::solve).empty() ? "solve" : "analyze";
  });
}

ExitStatus run_export(const CLI::App& command, const Arguments& arguments, const Options& options) {
  const bool of_study = command.get_option("--row")->count() > 0;
  if (!of_study && arguments.file.ends_with(".toml")) {
    complain(arguments.file + ": export takes a result; 'cognate " + command_for(arguments.file) +
             ' ' + arguments.file + "' writes one, NAME.result.json");
    return exit_bad_input;
  }
  const std::string other = arguments.exporting.any();
  if (of_study && !other.empty()) {
    complain(other + ": is for results; remove every other option but --row");
    return exit_bad_input;
  }
  if (of_study) {
    const auto row = parse_row(arguments.row);
    if (row) return export_row_command(arguments.file, *row, options);
    complain(row.error());
    return exit_bad_input;
  }
  if (!arguments.exporting.format) {
    const auto any = [](const FormatDeclaration&) { return true; };
    complain("--format is required: " + format_words(any, " or ") +
             "; of a study file --row ID instead");
    return exit_bad_input;
  }
  const auto wanted = export_options(arguments.exporting);
  if (wanted) return export_command(arguments.file, *wanted, options);
  for (const std::string& fault : wanted.error()) complain(fault);
  return exit_bad_input;
}

/// The name that two of `files` would give to what is written of them; empty where none would.
std::string shared_name(const std::vector<std::string>& files) {
  std::set<std::string> names;
  for (const std::string& file : files) {
    const std::string name = stem_of_result(file);
    if (!names.insert(name).second) return name;
  }
  return "";
}

/// Runs `command` on each of the files in turn, until an interrupt; the status is the worst. Of
/// several that are `written`, no two may give the same files.
template <class Run>
ExitStatus run_each(const std::vector<std::string>& files, const Options& options, bool written,
                    Run command) {
  const std::string shared = written && (!options.json || options.out) ? shared_name(files) : "";
  if (!shared.empty()) {
    complain("two of the files would write " + shared +
             ".result.json; run them one by one, each with an --out of its own");
    return exit_bad_input;
  }
  ExitStatus worst = exit_done;
  for (std::size_t i = 0; i < files.size(); ++i) {
    worst = std::max(worst, command(files[i]));
    const bool is_last = i + 1 == files.size();
    if (was_interrupted() && !is_last) {
      complain("interrupted; " + files[i + 1] +
               (i + 2 < files.size() ? " and those behind it" : "") + " not begun");
      return std::max(worst, exit_no_design);
    }
    if (!is_last) release_interrupts();
  }
  return worst;
}

ExitStatus run_analyze(const CLI::App& command, const Arguments& arguments,
                       const Options& options) {
  const bool one_design = command.get_option("--design")->count() > 0;
  const auto design = parse_design(arguments.exporting.design.value_or("1"));
  if (!design) {
    complain(design.error());
    return exit_bad_input;
  }
  return run_each(arguments.files, options, true, [&](const std::string& file) {
    const bool is_result = file.ends_with(".json");
    if (is_result) return analyze_design_command(file, *design, options);
    if (!one_design) return analyze_command(file, options);
    complain("--design: is of results; expected NAME.result.json, not " + file);
    return exit_bad_input;
  });
}

ExitStatus run_check(const CLI::App& command, const Arguments& arguments, const Options& options) {
  constexpr int kSample = 200;
  int sample = kSample;
  const bool given = command.get_option("--sample")->count() > 0;
  if (given && !take(parse_sample(arguments.sample), sample)) return exit_bad_input;
  if (given && !arguments.certificate) {
    complain("--sample: is of certificates; add --certificate and NAME.result.json");
    return exit_bad_input;
  }
  return run_each(arguments.files, options, false, [&](const std::string& file) {
    return arguments.certificate ? check_certificate_command(file, sample, options)
                                 : check_command(file, options);
  });
}

ExitStatus run_watch(const std::string& name, const Arguments& arguments, const Options& options) {
  const std::string& file = arguments.files.front();
  const bool is_result = name == "analyze" && file.ends_with(".json");
  if (arguments.files.size() > 1 || is_result) {
    complain("--watch: expected one problem file, NAME.toml");
    return exit_bad_input;
  }
  return watch_command(name == "solve" ? Command::solve : Command::analyze, file, options);
}

ExitStatus run_studio(const CLI::App& command, const Arguments& arguments, const Options& options) {
  StudioOptions studio{.opens_browser = !arguments.no_open};
  if (command.get_option("FILE")->count() > 0) studio.file = arguments.file;
  const bool at_port = command.get_option("--port")->count() > 0;
  if (at_port && !take(parse_port(arguments.port), studio.port)) return exit_bad_input;
  return studio_command(studio, options);
}

ExitStatus run_sweep(const CLI::App& command, const Arguments& arguments, const Options& options,
                     StudyProcesses& processes) {
  SweepOptions own{.merged = {arguments.merged.begin(), arguments.merged.end()}};
  const bool has_part = command.get_option("--part")->count() > 0;
  if (has_part && !take(parse_part(arguments.part), own.part)) return exit_bad_input;
  const bool has_format = command.get_option("--format")->count() > 0;
  if (has_format && !take(parse_row_format(arguments.row_format), own.writes_columns)) {
    return exit_bad_input;
  }
  return sweep_command(arguments.file, options, own, processes);
}

ExitStatus run_completion(const CommandLine& line) {
  const auto& shell = line.arguments.shell;
  if (shell == "bash") return print(bash_completion(command_tree(line)));
  if (shell == "zsh") return print(zsh_completion(command_tree(line)));
  if (shell == "fish") return print(fish_completion(command_tree(line)));
  complain("completion: '" + shell + "' is not possible; allowed is bash, zsh or fish");
  return exit_bad_input;
}

ExitStatus run_command(const CommandLine& line, StudyProcesses& processes) {
  const CLI::App& called = *line.app.get_subcommands().front();
  const Arguments& arguments = line.arguments;
  const std::string& name = called.get_name();
  if (name == "completion") return run_completion(line);
  if (name == "manual") return print(manual_page(command_tree(line), version()));
  const auto options = options_of(line.app, arguments);
  if (!options) return exit_bad_input;
  if (name == "new") return new_command(arguments.kind, *options);
  if (arguments.watch) return run_watch(name, arguments, *options);
  if (name == "studio") return run_studio(called, arguments, *options);
  if (name == "solve") {
    return run_each(arguments.files, *options, true,
                    [&](const std::string& file) { return solve_command(file, *options); });
  }
  if (name == "analyze") return run_analyze(called, arguments, *options);
  if (name == "sweep") return run_sweep(called, arguments, *options, processes);
  if (name == "export") return run_export(called, arguments, *options);
  if (name == "sketch") return sketch_command(arguments.mechanism, arguments.file, *options);
  if (name == "involute") {
    return involute_command(arguments.values, {arguments.inverse, arguments.csv}, *options);
  }
  if (name == "check") return run_check(called, arguments, *options);
  return list_command(arguments.kind, arguments.metrics, *options);
}

ExitStatus run(int argc, char** argv, StudyProcesses& processes) {
  CommandLine line;
  const auto refusal = refused_command(line, {argv, static_cast<std::size_t>(argc)});
  if (refusal) {
    complain(*refusal);
    return exit_bad_input;
  }
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return print(line.app.help());
  } catch (const CLI::CallForVersion&) {
    return print(line.app.version() + '\n');
  } catch (const CLI::ParseError& error) {
    complain(refusal_of(error, line));
    return exit_bad_input;
  }
  return run_command(line, processes);
}

}  // namespace
}  // namespace cognate::app

int main(int argc, char** argv) {
  cognate::app::hold_standard_descriptors();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing, as a full disk
  try {
    const auto processes = cognate::app::begin_processes(argc, argv);
    return processes ? cognate::app::run(argc, argv, *processes) : cognate::app::exit_bad_input;
  } catch (const std::exception& error) {
    cognate::app::complain(std::string("a fault of Cognate's own: ") + error.what());
  } catch (...) {
    cognate::app::complain("a fault of Cognate's own, of an unknown kind");
  }
  return cognate::app::exit_own_fault;
}
