#include <fmt/core.h>

#include "app/shell/completion.hpp"

namespace cognate::app {
namespace {

/// `text` within single quotes.
std::string in_fish_quotes(std::string_view text) {
  std::string safe = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe + "'";
}

std::string line_of(const OptionWords& option, const std::string& condition) {
  auto text = fmt::format("complete -c cognate -n {}", in_fish_quotes(condition));
  for (const auto& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.argument.empty()) text += " -x";
  if (!option.values.empty()) text += " -a " + in_fish_quotes(joined(option.values, " "));
  if (const auto endings = option.endings(); !endings.empty()) {
    text += fmt::format(" -k -a '(__fish_complete_suffix {})'",
                        joined(endings, "; __fish_complete_suffix "));
  }
  if (option.takes_folder()) text += " -a '(__fish_complete_directories)'";
  return text + " -d " + in_fish_quotes(option.meaning) + '\n';
}

}  // namespace

std::string fish_completion(const CommandTree& tree) {
  std::string text =
      "# Completion of cognate for fish, made by 'cognate completion fish'.\n"
      "complete -c cognate -f\n";
  for (const auto& option : tree.program.options) text += line_of(option, "__fish_use_subcommand");
  for (const auto& command : tree.all_commands()) {
    const auto condition = "__fish_seen_subcommand_from " + command.name;
    text += fmt::format("\ncomplete -c cognate -n '__fish_use_subcommand' -a {} -d {}\n",
                        command.name, in_fish_quotes(command.purpose));
    for (const auto& option : command.options) text += line_of(option, condition);
    if (!command.argument_values.empty()) {
      text += fmt::format("complete -c cognate -n {} -a {}\n", in_fish_quotes(condition),
                          in_fish_quotes(joined(command.argument_values, " ")));
    }
    for (const auto& ending : command.endings) {
      text += fmt::format("complete -c cognate -n {} -k -a '(__fish_complete_suffix {})'\n",
                          in_fish_quotes(condition), ending);
    }
  }
  return text;
}

}  // namespace cognate::app
