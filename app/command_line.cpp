#include "app/command_line.hpp"

#include <array>
#include <utility>

#include "app/help_texts.hpp"
#include "app/version.hpp"

namespace cognate::app {
namespace {

/// What the help calls the parts of a command line, for CLI11's own words.
constexpr std::array<std::pair<const char*, const char*>, 4> kLabels = {
    {{"SUBCOMMAND", "COMMAND"}, {"Positionals", "Arguments"}, {"REQUIRED", ""}, {"TEXT", ""}}};

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
  const auto add = [&](const char* name, std::string& value, const char* unit, const char* what) {
    return command.add_option(name, value, what)->type_name(unit);
  };
  add("--format", arguments.format, "dxf|svg|csv", "for CAD, a picture, or a table");
  add("--row", arguments.row, "ID", "of a study file: the design with this id");
  add("--design", arguments.design, "N", "which design, from 1 (default 1, the best)");
  add("--curve", arguments.curve, "profile|pitch|cutter",
      "the profile (default), the path of the roller's centre or that of a cutter's");
  add("--cutter-radius", arguments.cutter_radius, "R", "of the cutter, for --curve cutter");
  add("--chord-tolerance", arguments.chord_tolerance, "T",
      "greatest distance of polygon and curve (default 1e-4 of the base radius)");
}

}  // namespace

CommandLine::CommandLine() : app(kDescription, "cognate") {
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
  auto& exporting =
      add_command(app, arguments, "export",
                  "Write a cam's curves for CAD, as a picture or a table, or a design of a study.",
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
}

}  // namespace cognate::app
