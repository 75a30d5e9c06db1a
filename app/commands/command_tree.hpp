/// @file The command line as a tree of words, from which completion and the manual page are
/// written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cognate::app {

struct CommandLine;

/// An option as a user types it.
struct OptionWords {
  std::vector<std::string> names;  ///< with their dashes, the short one first
  std::string argument;            ///< what follows it, "SECONDS" or "dxf|svg"; empty: nothing does
  std::string meaning;
  std::vector<std::string> values;  ///< the only ones allowed; empty where any may follow

  bool takes_folder() const { return argument == "DIR"; }
  /// Of the files that it takes; none where it takes no files.
  std::vector<std::string> endings() const {
    if (argument != "STUDY") return {};
    return {".study.db", ".study.h5"};
  }
  const std::string& long_name() const { return names.back(); }
};

/// A command, or the program as a whole.
struct CommandWords {
  std::string name;
  std::string purpose;
  std::string more;  ///< what its help says after the options
  std::vector<OptionWords> options;
  std::string argument;  ///< what its file or word is called; empty: it takes none
  std::string argument_meaning;
  bool takes_several = false;                ///< of its argument
  std::vector<std::string> argument_values;  ///< the only ones allowed; empty where any may be
  std::vector<std::string> endings;          ///< of files that it reads, ".toml"
};

struct CommandTree {
  CommandWords program;
  std::vector<CommandWords> commands;  ///< those that help shows, in its order
  std::vector<CommandWords> hidden;    ///< those that are called once: completion and manual

  /// Both, those that help shows first.
  std::vector<CommandWords> all_commands() const;
};

/// The tree of what `line` defines.
CommandTree command_tree(const CommandLine& line);

/// `words` one behind the other, `between` two of them.
std::string joined(const std::vector<std::string>& words, std::string_view between);

}  // namespace cognate::app
