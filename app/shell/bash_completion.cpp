#include <fmt/core.h>

#include "app/shell/completion.hpp"

namespace cognate::app {
namespace {

constexpr const char* kHead =
    R"(# Completion of cognate for bash, made by 'cognate completion bash'.

# Those of the words in $1 that begin with $2.
_cognate_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
}

# The folders, and the files whose names end as one of $2... do, that begin with $1.
_cognate_files() {
  local current=$1 ending
  shift
  mapfile -t COMPREPLY < <(
    compgen -d -- "$current"
    for ending; do compgen -f -X "!*$ending" -- "$current"; done)
  compopt -o filenames 2>/dev/null
}

_cognate() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command= word
  COMPREPLY=()
  # bash takes --option=value for three words.
  if [[ $current == = ]]; then
    current=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in
)";

constexpr const char* kTail = R"(}
complete -F _cognate cognate
)";

std::string names_of(const CommandWords& command) {
  std::string all;
  for (const auto& option : command.options) {
    for (const auto& name : option.names) all += (all.empty() ? "" : " ") + name;
  }
  return all;
}

/// What may follow an option with an argument: certain values, files, a folder, or what nobody can
/// guess.
std::string value_cases(const CommandWords& command) {
  std::string text;
  for (const auto& option : command.options) {
    if (option.argument.empty()) continue;
    const auto pattern =
        fmt::format("{0}:{1}", command.name, joined(option.names, "|" + command.name + ":"));
    if (!option.values.empty()) {
      text += fmt::format("    {}) _cognate_words '{}' \"$current\"; return ;;\n", pattern,
                          joined(option.values, " "));
    } else if (const auto endings = option.endings(); !endings.empty()) {
      text += fmt::format("    {}) _cognate_files \"$current\" {}; return ;;\n", pattern,
                          joined(endings, " "));
    } else if (option.takes_folder()) {
      text += fmt::format("    {}) _cognate_files \"$current\"; return ;;\n", pattern);
    } else {
      text += fmt::format("    {}) return ;;\n", pattern);
    }
  }
  return text;
}

std::string word_case(const CommandWords& command) {
  std::string files;
  for (const auto& ending : command.endings) files += " " + ending;
  std::string otherwise;
  if (!files.empty()) otherwise = fmt::format("_cognate_files \"$current\"{}", files);
  if (!command.argument_values.empty()) {
    otherwise =
        fmt::format("_cognate_words '{}' \"$current\"", joined(command.argument_values, " "));
  }
  return fmt::format("    {0}:-*) _cognate_words '{1}' \"$current\" ;;\n    {0}:*) {2} ;;\n",
                     command.name, names_of(command), otherwise);
}

}  // namespace

std::string bash_completion(const CommandTree& tree) {
  CommandWords program = tree.program;
  program.name.clear();
  std::vector<std::string> names;
  const auto commands = tree.all_commands();
  for (const auto& command : commands) names.push_back(command.name);

  std::string text = kHead;
  text += fmt::format("      {}) command=$word; break ;;\n    esac\n  done\n", joined(names, "|"));
  text += "  case $command:$previous in\n" + value_cases(program);
  for (const auto& command : commands) text += value_cases(command);
  text += "  esac\n  case $command:$current in\n";
  text += fmt::format("    :-*) _cognate_words '{}' \"$current\" ;;\n", names_of(program));
  text += fmt::format("    :*) _cognate_words '{}' \"$current\" ;;\n", joined(names, " "));
  for (const auto& command : commands) text += word_case(command);
  return text + "  esac\n" + kTail;
}

}  // namespace cognate::app
