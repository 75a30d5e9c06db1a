/// @file The program `cognate`: what it is told on the command line, and how it ends.
#include <CLI/CLI.hpp>
#include <exception>
#include <optional>
#include <string>
#include <tuple>

#include "app/command_line.hpp"
#include "app/command_line_faults.hpp"
#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/shell/completion.hpp"
#include "app/shell/manual_page.hpp"
#include "app/study/study_processes.hpp"
#include "app/terminal.hpp"
#include "app/version.hpp"

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
  if (given("--out")) allowed &= take(parse_folder(arguments.out), options.out);
  return allowed ? std::optional(options) : std::nullopt;
}

/// The options of `export`; empty, once every fault has been said, where one is not allowed.
std::optional<ExportOptions> export_options_of(const CLI::App& command,
                                               const Arguments& arguments) {
  const auto given = [&](const char* name) { return command.get_option(name)->count() > 0; };
  ExportOptions options;
  bool allowed = take(parse_format(arguments.format), options.format);
  if (given("--design")) allowed &= take(parse_design(arguments.design), options.design);
  if (given("--curve")) allowed &= take(parse_curve(arguments.curve), options.order.kind);
  for (const auto& [name, text, value] :
       {std::tuple("--cutter-radius", &arguments.cutter_radius, &options.order.cutter_radius),
        std::tuple("--chord-tolerance", &arguments.chord_tolerance,
                   &options.order.chord_tolerance)}) {
    if (given(name)) allowed &= take(parse_length(name, *text), *value);
  }
  const bool cuts = options.order.kind == ExportedCurve::cutter;
  if (allowed && cuts != given("--cutter-radius")) {
    complain(cuts ? "--curve: 'cutter' wants the cutter's radius; --cutter-radius R is missing"
                  : "--cutter-radius: only the path of a cutter has one; --curve cutter is wanted "
                    "with it");
    return std::nullopt;
  }
  return allowed ? std::optional(options) : std::nullopt;
}

ExitStatus run_export(const CLI::App& command, const Arguments& arguments, const Options& options) {
  const auto given = [&](const char* name) { return command.get_option(name)->count() > 0; };
  if (arguments.file.ends_with(".toml")) {
    complain(arguments.file + ": export takes a result; 'cognate solve " + arguments.file +
             "' writes one, NAME.result.json");
    return exit_bad_input;
  }
  if (!given("--row") && !given("--format")) {
    complain("--format is required: dxf, svg or csv; of a study file --row ID instead");
    return exit_bad_input;
  }
  if (given("--row")) {
    for (const char* name :
         {"--format", "--design", "--curve", "--cutter-radius", "--chord-tolerance"}) {
      if (!given(name)) continue;
      complain(std::string(name) + ": is for results; with --row no other option is wanted");
      return exit_bad_input;
    }
    const auto row = parse_row(arguments.row);
    if (row) return export_row_command(arguments.file, *row, options);
    complain(row.error());
    return exit_bad_input;
  }
  const auto wanted = export_options_of(command, arguments);
  return wanted ? export_command(arguments.file, *wanted, options) : exit_bad_input;
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
  if (name == "solve") return solve_command(arguments.file, *options);
  if (name == "analyze") return analyze_command(arguments.file, *options);
  if (name == "sweep") return sweep_command(arguments.file, *options, processes);
  if (name == "export") return run_export(called, arguments, *options);
  if (name == "check") return check_command(arguments.file, *options);
  return list_command(arguments.metrics, *options);
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
