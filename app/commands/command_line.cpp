#include "app/commands/command_line.hpp"

#include <array>
#include <utility>

#include "app/commands/help_texts.hpp"
#include "app/commands/starters.hpp"
#include "app/documents/version.hpp"

namespace cognate::app {
namespace {

/// What the help calls the parts of a command line, for CLI11's own words.
constexpr std::array<std::pair<const char*, const char*>, 4> kLabels = {
    {{"SUBCOMMAND", "COMMAND"}, {"Positionals", "Arguments"}, {"REQUIRED", ""}, {"TEXT", ""}}};

void add_common_options(CLI::App& app, Arguments& arguments) {
  app.add_flag("--json", arguments.json, "print a JSON document and nothing else");
  app.add_option("--seed", arguments.seed, "start of all random choices (default 1)")
      ->type_name("N");
  app.add_option("--threads", arguments.threads, "threads to use (default: all processors)")
      ->type_name("N");
  app.add_option("--time-limit", arguments.time_limit, "stop then, and report what was found")
      ->type_name("SECONDS");
  app.add_flag("--quiet", arguments.quiet, "print neither progress nor table");
}

void add_folder(CLI::App& command, Arguments& arguments) {
  command.add_option("--out", arguments.out, "folder of the files (default: the current one)")
      ->type_name("DIR");
}

void add_watch(CLI::App& command, Arguments& arguments) {
  command.add_flag("--watch", arguments.watch, "again whenever FILE is saved, until Ctrl-C");
}

void add_length_unit(CLI::App& command, Arguments& arguments) {
  command.add_option("--length-unit", arguments.length_unit, "of a file that gives none")
      ->type_name("mm|cm|m|in");
}

/// "dxf|svg|...".
std::string alternatives() {
  std::string text;
  for (const FormatDeclaration& format : kExportFormats) {
    text.append(text.empty() ? "" : "|").append(format.word);
  }
  return text;
}

std::string export_footer() {
  std::string text = kExportHead;
  for (const FormatDeclaration& format : kExportFormats) {
    text.append("    ").append(format.help).append("\n");
  }
  return text + kExportTail;
}

void add_export_options(CLI::App& command, Arguments& arguments) {
  const auto add = [&](const char* name, auto& value, const char* unit, const char* what) {
    command.add_option(name, value, what)->type_name(unit);
  };
  ExportTexts& texts = arguments.exporting;
  add("--format", texts.format, alternatives().c_str(), "what to write");
  add("--row", arguments.row, "ID", "of a study file: the design with this id");
  add("--design", texts.design, "N", "which design, from 1 (default 1, the best)");
  add("--chord-tolerance", texts.chord_tolerance, "T", "of polygons (default 1e-4 of the size)");
  add("--dxf-version", texts.dxf_version, "r12|2000", "of the DXF file (default 2000)");
  add("--curve", texts.curve, "profile|pitch|cutter",
      "profile (default), path of roller centre or cutter");
  add("--cutter-radius", texts.cutter_radius, "R", "of the cutter, for --curve cutter");
  add("--position", texts.position, "DEG", "of a linkage's drive (default: the first possible)");
  add("--steps", texts.steps, "N", "of a linkage: rows of the table, less one");
  command.add_flag("--parts", texts.parts, "of a linkage: its links as flat parts to cut");
  add("--hole", texts.hole, "D", "of parts: diameter of the holes");
  add("--width", texts.width, "W", "of parts: width of the bars");
  add("--thickness", texts.thickness, "T", "of parts: of the sheet; of solids of wheels");
  add("--clearance", texts.clearance, "C", "of parts: of pins in slots (default 0)");
  add("--gap", texts.gap, "G", "of parts: between them (default half the width)");
  add("--sheet", texts.sheet, "WxH", "of parts: packed on sheets of this size");
  add("--labels", texts.labels, "none|text|stroke", "of parts: names (default text)");
  add("--bearing", texts.bearing, "NUMBER", "of parts: on pins, such as 608 or 619/5");
  add("--screw", texts.screw, "M5", "of parts: screws as pins, with nuts and washers");
  add("--washer", texts.washer, "T[xD]", "of parts: washers between layers, D outside");
  add("--boss", texts.boss, "D", "of solid parts: bosses where pins cross layers");
  add("--block", texts.block, "LxW", "of parts: blocks about the pins that run in slots");
  command.add_flag("--spacers", texts.spacers, "of parts: rings for layers that pins cross");
  command.add_flag("--bill", texts.bill, "of parts: also a bill of material, NAME.bill.csv");
  add("--kerf", texts.kerf, "K", "of parts, gears, cams: width of a cut (default 0)");
  add("--bore", texts.bore, "D", "of gears and cams; of a pair also D1,D2");
  command.add_flag("--keyway", texts.keyway, "of a bore: a keyway of DIN 6885");
  add("--hub", texts.hub, "D", "of gears and cams: a circle, of solids a boss");
  add("--hub-length", texts.hub_length, "L", "of solids: of the wheel with its hub");
  command.add_flag("--timing-mark", texts.timing_mark, "of a cam: a line at cam angle 0");
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const Starter& starter : starters()) names.emplace_back(starter.kind);
  return names;
}

}  // namespace

CLI::App& CommandLine::add_command(const char* name, const char* purpose, const char* footer) {
  CLI::App& command = *app.add_subcommand(name, purpose);
  command.get_option("--help")->description("print this help");
  add_common_options(command, arguments);
  command.group("Commands");
  command.footer(footer);
  return command;
}

CLI::App& CommandLine::add_file_command(const char* name, const char* purpose, const char* footer,
                                        const char* file, std::vector<std::string> read) {
  CLI::App& command = add_command(name, purpose, footer);
  command.add_option("FILE", arguments.file, file)->required();
  endings[name] = std::move(read);
  return command;
}

CLI::App& CommandLine::add_files_command(const char* name, const char* purpose, const char* footer,
                                         const char* file, std::vector<std::string> read) {
  CLI::App& command = add_command(name, purpose, footer);
  command.add_option("FILE", arguments.files, file)->required();
  endings[name] = std::move(read);
  return command;
}

void CommandLine::add_studio() {
  auto& studio = add_command("studio", "Edit and solve a file in the browser.", kStudioFooter);
  studio.add_option("FILE", arguments.file, "a problem, TOML file (default: a new one)");
  endings["studio"] = {".toml"};
  studio.add_option("--port", arguments.port, "of the address (default: one that is free)")
      ->type_name("N");
  studio.add_flag("--no-open", arguments.no_open, "print the address, but open no browser");
  add_length_unit(studio, arguments);
}

void CommandLine::add_check() {
  auto& check =
      add_files_command("check", "Validate a file; check a certificate.", kCheckFooter,
                        "TOML files; with --certificate results", {".toml", ".result.json"});
  check.add_flag("--certificate", arguments.certificate,
                 "check the proof of the best design again");
  check.add_option("--sample", arguments.sample, "how many boxes of the proof (default 200)")
      ->type_name("N");
}

void CommandLine::add_sweep() {
  auto& sweep = add_file_command("sweep", "Run a study: vary numbers, keep rows.", kSweepFooter,
                                 "the study, a TOML file", {".toml"});
  add_folder(sweep, arguments);
  sweep.add_option("--part", arguments.part, "evaluate this part of the designs alone")
      ->type_name("K/N");
  sweep.add_option("--merge", arguments.merged, "first take over rows of NAME.study.db or .h5")
      ->type_name("STUDY")
      ->allow_extra_args(false);
  sweep.add_option("--format", arguments.row_format, "hdf5: in the end the rows as columns, too")
      ->type_name("sqlite|hdf5");
}

/// Those that packagers call and a user once.
void CommandLine::add_hidden_commands() {
  auto& completion = *app.add_subcommand("completion", "Print a script that completes commands.");
  completion.group("");
  completion.get_option("--help")->description("print this help");
  completion.add_option("SHELL", arguments.shell, "which shell is to be taught")
      ->type_name("bash|zsh|fish")
      ->required();
  completion.footer(kCompletionFooter);
  auto& manual = *app.add_subcommand("manual", "Print the manual page, source for man.");
  manual.group("");
  manual.get_option("--help")->description("print this help");
  manual.footer(kManualFooter);
}

CommandLine::CommandLine() : app(kDescription, "cognate") {
  app.footer(kFooter);
  app.set_version_flag("--version", "cognate " + std::string(version()), "print the version");
  app.require_subcommand(1);
  app.get_option("--help")->description("print this help");
  for (const auto& [label, shown] : kLabels) app.get_formatter()->label(label, shown);
  add_common_options(app, arguments);
  auto& starting = add_command("new", "Write a commented file to start from.", kNewFooter);
  starting.add_option("KIND", arguments.kind, "the kind of problem")->required();
  add_folder(starting, arguments);
  auto& solving = add_files_command("solve", "Find designs for a problem.", kSolveFooter,
                                    "problems, TOML files", {".toml"});
  add_folder(solving, arguments);
  solving.add_option("--steps", arguments.steps, "of a cam's table over a turn (default 360)")
      ->type_name("N");
  add_length_unit(solving, arguments);
  add_watch(solving, arguments);
  auto& analyzing =
      add_files_command("analyze", "Evaluate a mechanism over its drive.", kAnalyzeFooter,
                        "TOML files of mechanisms, or results", {".toml", ".result.json"});
  add_folder(analyzing, arguments);
  analyzing
      .add_option("--design", arguments.exporting.design, "of a result: which design (default 1)")
      ->type_name("N");
  add_length_unit(analyzing, arguments);
  add_watch(analyzing, arguments);
  add_sweep();
  auto& exporting = add_file_command("export", "Write a result for CAD, as a picture or a table.",
                                     export_footer().c_str(),
                                     "NAME.result.json, or a study, NAME.study.db or .h5",
                                     {".result.json", ".study.db", ".study.h5"});
  add_folder(exporting, arguments);
  add_length_unit(exporting, arguments);
  add_export_options(exporting, arguments);
  auto& sketch =
      add_command("sketch", "Write a page to draw on: targets, or a mechanism.", kSketchFooter);
  sketch.add_option("FILE", arguments.file, "a mechanism to begin with, TOML file");
  endings["sketch"] = {".toml"};
  sketch.add_flag("--mechanism", arguments.mechanism, "the page on which a mechanism is built");
  sketch.add_option("--out", arguments.out, "the page (default: sketch.html, mechanism.html)")
      ->type_name("FILE");
  add_studio();
  auto& involute =
      add_command("involute", "Tabulate the involute function or its inverse.", kInvoluteFooter);
  involute.add_option("VALUE", arguments.values, "angles in degrees, or ranges FROM:TO:STEP");
  involute.add_flag("--inverse", arguments.inverse, "angles of these values of the involute");
  involute.add_flag("--csv", arguments.csv, "as CSV, every digit");
  add_check();
  auto& list = add_command("list", "Say what can be requested, and by which keys.", kListFooter);
  list.add_option("KIND", arguments.kind, "of this kind of problem alone");
  for (const char* command : {"new", "list"}) words[command] = kind_names();
  list.add_flag("--metrics", arguments.metrics, "every number of a result, with its unit");
  add_hidden_commands();
}

}  // namespace cognate::app
