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
  std::string shell;  ///< of `completion`
  std::string seed, threads, time_limit, out;
  std::string row;  ///< of a study, for `export`
  ExportTexts exporting;
  bool json = false;
  bool quiet = false;
  bool metrics = false;
};

/// The commands and options, and where parsing puts what was written. It is not to be moved: the
/// definition points at `arguments`.
struct CommandLine {
  CommandLine();

  Arguments arguments;
  CLI::App app;
  std::map<std::string, std::vector<std::string>> endings;  ///< of the files that a command reads

 private:
  CLI::App& add_command(const char* name, const char* purpose, const char* footer);
  /// A command that reads a file with one of `read` for its ending.
  CLI::App& add_file_command(const char* name, const char* purpose, const char* footer,
                             const char* file, std::vector<std::string> read);
  void add_hidden_commands();
};

}  // namespace cognate::app
