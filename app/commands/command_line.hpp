/// @file The definition of the command line: commands, options and what the help says of them.
/// Help, completion and manual pages are made from it.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "app/export/export_options.hpp"

namespace cognate::app {

/// What the command line says, as it was written.
struct Arguments {
  std::string file;
  std::vector<std::string> files;   ///< of the commands that take several
  std::vector<std::string> values;  ///< of `involute`
  std::string kind;                 ///< of `new` and `list`
  std::string shell;                ///< of `completion`
  std::string seed, threads, time_limit, out, steps, length_unit;
  std::string row;                  ///< of a study, for `export`
  std::string port;                 ///< of `studio`
  std::string sample;               ///< of `check`, of a certificate
  std::string part;                 ///< of a study, for `sweep`
  std::vector<std::string> merged;  ///< study files, for `sweep`
  std::string row_format;           ///< of a study, for `sweep`
  ExportTexts exporting;
  bool json = false;
  bool quiet = false;
  bool metrics = false;
  bool inverse = false, csv = false;  ///< of `involute`
  bool mechanism = false;             ///< of `sketch`
  bool certificate = false;           ///< of `check`
  bool watch = false;                 ///< of the commands that compute
  bool no_open = false;               ///< of `studio`
};

/// The commands and options, and where parsing puts what was written. It is not to be moved: the
/// definition points at `arguments`.
struct CommandLine {
  CommandLine();

  Arguments arguments;
  CLI::App app;
  std::map<std::string, std::vector<std::string>> endings;  ///< of the files that a command reads
  std::map<std::string, std::vector<std::string>> words;    ///< that may stand behind a command

 private:
  CLI::App& add_command(const char* name, const char* purpose, const char* footer);
  /// A command that reads a file with one of `read` for its ending.
  CLI::App& add_file_command(const char* name, const char* purpose, const char* footer,
                             const char* file, std::vector<std::string> read);
  /// A command that reads one file or several.
  CLI::App& add_files_command(const char* name, const char* purpose, const char* footer,
                              const char* file, std::vector<std::string> read);
  void add_studio();
  void add_check();
  void add_sweep();
  void add_hidden_commands();
};

}  // namespace cognate::app
