#include <fmt/core.h>

#include "app/shell/completion.hpp"

namespace cognate::app {
namespace {

/// `text` as it may stand in a description within single quotes.
std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\'') {
      safe += "'\\''";
    } else {
      if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
      safe += c;
    }
  }
  return safe;
}

std::string argument_of(const OptionWords& option) {
  if (option.argument.empty()) return "";
  const auto name = escaped(option.argument);
  if (!option.values.empty()) {
    return fmt::format(":{}:({})", name, joined(option.values, " "));
  }
  if (const auto endings = option.endings(); !endings.empty()) {
    return fmt::format(":{}:_files -g \"*{}\"", name, joined(endings, " *"));
  }
  return fmt::format(":{}:{}", name, option.takes_folder() ? "_files -/" : " ");
}

std::string specification(const OptionWords& option) {
  const char* behind = option.argument.empty() ? "" : "=";
  const auto rest = fmt::format("[{}]{}", escaped(option.meaning), argument_of(option));
  if (option.names.size() == 1) {
    return fmt::format("'{}{}{}'", option.names.front(), behind, rest);
  }
  return fmt::format("'({0})'{{{1}}}'{2}'", joined(option.names, " "), joined(option.names, ","),
                     rest);
}

/// The words that describe the options to `_arguments`, each on a line of its own.
std::string specifications(const CommandWords& command, const std::string& indent) {
  std::string text;
  for (const auto& option : command.options) {
    text += " \\\n" + indent + specification(option);
  }
  return text;
}

std::string command_case(const CommandWords& command) {
  auto text = fmt::format("        {})\n          _arguments{}", command.name,
                          specifications(command, "            "));
  if (!command.endings.empty()) {
    std::vector<std::string> patterns;
    for (const auto& ending : command.endings) patterns.push_back("*" + ending);
    text +=
        fmt::format(" \\\n            '{}:{}:_files -g \"{}\"'", command.takes_several ? '*' : '1',
                    escaped(command.argument), joined(patterns, " "));
  }
  if (!command.argument_values.empty()) {
    text += fmt::format(" \\\n            '1:{}:({})'", escaped(command.argument),
                        joined(command.argument_values, " "));
  }
  return text + " ;;\n";
}

}  // namespace

std::string zsh_completion(const CommandTree& tree) {
  std::string text =
      "#compdef cognate\n"
      "# Completion of cognate for zsh, made by 'cognate completion zsh'.\n\n"
      "_cognate() {\n"
      "  local context state state_descr line\n"
      "  typeset -A opt_args\n"
      "  local -a commands=(\n";
  const auto commands = tree.all_commands();
  for (const auto& command : commands) {
    text += fmt::format("    '{}:{}'\n", command.name, escaped(command.purpose));
  }
  text += "  )\n  _arguments -C" + specifications(tree.program, "    ");
  text +=
      " \\\n    '1:COMMAND:->command' \\\n    '*::argument:->argument'\n"
      "  case $state in\n"
      "    command) _describe -t commands command commands ;;\n"
      "    argument)\n"
      "      case $line[1] in\n";
  for (const auto& command : commands) text += command_case(command);
  return text +
         "      esac ;;\n"
         "  esac\n"
         "}\n\n"
         "# Called by the completion system, or read by 'source'.\n"
         "if [[ ${funcstack[1]} == _cognate ]]; then\n"
         "  _cognate \"$@\"\n"
         "else\n"
         "  compdef _cognate cognate\n"
         "fi\n";
}

}  // namespace cognate::app
