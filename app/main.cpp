/// @file The program `cognate`: what it is told on the command line, and how it ends.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "app/commands.hpp"
#include "app/help_texts.hpp"
#include "app/messages.hpp"
#include "app/study/study_processes.hpp"
#include "app/terminal.hpp"
#include "app/version.hpp"

namespace cognate::app {
namespace {

constexpr const char* kNoCommand =
    "no command of this version; available are solve, analyze, sweep, export, check and list; see "
    "'cognate --help'";

/// What the help calls the parts of a command line, for CLI11's own words.
constexpr std::array<std::pair<const char*, const char*>, 4> kLabels = {
    {{"SUBCOMMAND", "COMMAND"}, {"Positionals", "Arguments"}, {"REQUIRED", ""}, {"TEXT", ""}}};

/// What the command line says, as it was written.
struct Arguments {
  std::string file;
  std::string seed, threads, time_limit, out;
  std::string row;
  ExportTexts exporting;
  bool json = false;
  bool quiet = false;
  bool metrics = false;
};

void add_common_options(CLI::App& app, Arguments& arguments) {
  app.add_flag("--json", arguments.json, "print a JSON document on standard output, nothing else");
  app.add_option("--seed", arguments.seed, "start of all random choices (default 1)")
      ->type_name("N");
  app.add_option("--threads", arguments.threads, "threads to use (default: all processors)")
      ->type_name("N");
  app.add_option("--time-limit", arguments.time_limit, "stop then, and report what was found")
      ->type_name("SECONDS");
  app.add_flag("--quiet", arguments.quiet, "print neither progress nor table");
}

CLI::App& add_command(CLI::App& app, Arguments& arguments, const char* name, const char* purpose,
                      const char* footer) {
  CLI::App& command = *app.add_subcommand(name, purpose);
  command.get_option("--help")->description("print this help");
  add_common_options(command, arguments);
  command.group("Commands");
  command.footer(footer);
  return command;
}

void add_file(CLI::App& command, Arguments& arguments,
              const char* what = "the problem, a TOML file") {
  command.add_option("FILE", arguments.file, what)->required();
}

void add_folder(CLI::App& command, Arguments& arguments) {
  command.add_option("--out", arguments.out, "folder of the files (default: the current one)")
      ->type_name("DIR");
}

void add_export_options(CLI::App& command, Arguments& arguments) {
  const auto add = [&](const char* name, auto& value, const char* unit, const char* what) {
    command.add_option(name, value, what)->type_name(unit);
  };
  ExportTexts& texts = arguments.exporting;
  add("--format", texts.format, "dxf|svg|csv|json|dot",
      "for CAD, a picture, a table, or of linkages a document or a Graphviz sketch");
  add("--row", arguments.row, "ID", "of a study file: the design with this id");
  add("--design", texts.design, "N", "which design, from 1 (default 1, the best)");
  add("--chord-tolerance", texts.chord_tolerance, "T",
      "greatest distance of polygon and curve (default 1e-4 of the size)");
  add("--dxf-version", texts.dxf_version, "r12|2000", "of the DXF file (default 2000)");
  add("--curve", texts.curve, "profile|pitch|cutter",
      "of a cam: the profile (default), the path of the roller's centre or that of a cutter's");
  add("--cutter-radius", texts.cutter_radius, "R", "of the cutter, for --curve cutter");
  add("--position", texts.position, "DEG",
      "of a linkage: where the drive is (default: the first place where it can be assembled)");
  add("--steps", texts.steps, "N", "of a linkage: rows of the table, less one");
  command.add_flag("--parts", texts.parts, "of a linkage: its links as flat parts to be cut");
  add("--hole", texts.hole, "D", "of parts: diameter of the holes");
  add("--width", texts.width, "W", "of parts: width of the bars");
  add("--thickness", texts.thickness, "T", "of parts: of the sheet, for the lengths of pins");
  add("--clearance", texts.clearance, "C", "of parts: slots are wider than pins by C (default 0)");
  add("--gap", texts.gap, "G", "of parts: distance on the sheet (default half the width)");
}

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

ExitStatus run_export(const CLI::App& command, const Arguments& arguments, const Options& options) {
  const bool of_study = command.get_option("--row")->count() > 0;
  const std::string other = arguments.exporting.any();
  if (of_study && !other.empty()) {
    complain(other + ": is for results; with --row no other option is wanted");
    return exit_bad_input;
  }
  if (of_study) {
    const auto row = parse_row(arguments.row);
    if (row) return export_row_command(arguments.file, *row, options);
    complain(row.error());
    return exit_bad_input;
  }
  if (!arguments.exporting.format) {
    complain("--format is required: dxf, svg, csv, json or dot; of a study file --row ID instead");
    return exit_bad_input;
  }
  const auto wanted = export_options(arguments.exporting);
  if (wanted) return export_command(arguments.file, *wanted, options);
  for (const std::string& fault : wanted.error()) complain(fault);
  return exit_bad_input;
}

/// Refuses what is not a command of this version; true where `name` may be one.
bool may_be_command(std::string_view name) {
  constexpr std::array<std::string_view, 6> kCommands = {"solve",  "analyze", "sweep",
                                                         "export", "check",   "list"};
  const bool known = std::ranges::find(kCommands, name) != kCommands.end();
  if (known || name.starts_with('-')) return true;
  complain("'" + std::string(name) +
           "' is not a command; available are solve, analyze, sweep, export, check and list");
  return false;
}

ExitStatus complain_about(const CLI::ParseError& error, const CLI::App& app) {
  const auto called = app.get_subcommands();
  if (called.empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    complain(kNoCommand);
    return exit_bad_input;
  }
  const std::string name = called.empty() ? "" : " " + called.front()->get_name();
  complain(std::string(error.what()) + "; 'cognate" + name + " --help' says what is allowed");
  return exit_bad_input;
}

ExitStatus run(int argc, char** argv, StudyProcesses& processes) {
  Arguments arguments;
  CLI::App app(kDescription, "cognate");
  app.footer(kFooter);
  app.set_version_flag("--version", "cognate " + std::string(version()), "print the version");
  app.require_subcommand(1);
  app.get_option("--help")->description("print this help");
  for (const auto& [label, shown] : kLabels) app.get_formatter()->label(label, shown);
  add_common_options(app, arguments);
  auto& solve = add_command(app, arguments, "solve", "Find designs for a problem.", kSolveFooter);
  add_file(solve, arguments);
  add_folder(solve, arguments);
  auto& analyze = add_command(app, arguments, "analyze", "Evaluate a mechanism over its drive.",
                              kAnalyzeFooter);
  add_file(analyze, arguments);
  add_folder(analyze, arguments);
  auto& sweep =
      add_command(app, arguments, "sweep", "Run a study: vary numbers, keep rows.", kSweepFooter);
  add_file(sweep, arguments, "the study, a TOML file");
  add_folder(sweep, arguments);
  auto& exporting = add_command(
      app, arguments, "export",
      "Write a linkage or a cam for CAD, as a picture or a table, or a design of a study.",
      kExportFooter);
  add_file(exporting, arguments, "a result, NAME.result.json, or a study file, NAME.study.db");
  add_folder(exporting, arguments);
  add_export_options(exporting, arguments);
  auto& check =
      add_command(app, arguments, "check", "Validate a file without solving it.", kCheckFooter);
  add_file(check, arguments);
  auto& list =
      add_command(app, arguments, "list",
                  "Say what can be asked for: problem kinds, mechanisms, solvers.", kListFooter);
  list.add_flag("--metrics", arguments.metrics,
                "every metric of a result and column of a table, with its unit");

  if (argc < 2) {
    complain(kNoCommand);
    return exit_bad_input;
  }
  if (!may_be_command(argv[1])) return exit_bad_input;
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return print(app.help());
  } catch (const CLI::CallForVersion&) {
    return print(app.version() + '\n');
  } catch (const CLI::ParseError& error) {
    return complain_about(error, app);
  }

  const CLI::App& called = *app.get_subcommands().front();
  const auto options = options_of(app, arguments);
  if (!options) return exit_bad_input;
  if (called.get_name() == "solve") return solve_command(arguments.file, *options);
  if (called.get_name() == "analyze") return analyze_command(arguments.file, *options);
  if (called.get_name() == "sweep") {
    return sweep_command(arguments.file, *options, processes);
  }
  if (called.get_name() == "export") return run_export(called, arguments, *options);
  if (called.get_name() == "check") return check_command(arguments.file, *options);
  return list_command(arguments.metrics, *options);
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
