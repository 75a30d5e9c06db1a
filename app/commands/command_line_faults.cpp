#include "app/commands/command_line_faults.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "app/commands/command_tree.hpp"
#include "problems/basics/enumeration.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::app {
namespace {

std::vector<std::string> command_names(const CommandLine& line) {
  std::vector<std::string> names;
  for (const auto& command : command_tree(line).commands) names.push_back(command.name);
  return names;
}

/// The word of `known` that was probably meant by `word`.
std::optional<std::string> meant(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> views(known.begin(), known.end());
  const auto found = problems::reading::nearest(word, views);
  return found ? std::optional<std::string>(*found) : std::nullopt;
}

bool names_a_file(const std::string& word) {
  std::error_code error;
  return word.ends_with(".toml") || std::filesystem::exists(word, error);
}

/// What `word` in the place of the command should perhaps have been.
std::string advice(const CommandLine& line, const std::string& word) {
  if (word == "help") return "did you mean --help";
  if (word == "version") return "did you mean --version";
  const auto names = command_names(line);
  if (const auto command = meant(word, names)) return "did you mean " + *command;
  if (names_a_file(word)) return fmt::format("for a file write 'cognate solve {}'", word);
  return "'cognate --help' says more";
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options({})) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Of words that are left over: the option nobody knows, else the first. Behind `--` no word is an
/// option.
std::string refusal_of_extra(const CLI::App& command, const std::vector<std::string>& extras,
                             const std::string& help) {
  const auto is_option = [](const std::string& word) { return word.starts_with('-'); };
  const auto behind = std::ranges::find(extras, "--");
  const auto option = std::find_if(extras.begin(), behind, is_option);
  const auto of = command.get_name() == "cognate" ? "" : " of " + command.get_name();
  if (option == behind) {
    const auto takes = [&](const char* word) {
      return command.get_option_no_throw(word) != nullptr;
    };
    const char* const taken = takes("FILE") ? "one FILE" : takes("KIND") ? "one KIND" : "no file";
    const auto& word = behind == extras.begin() ? extras.at(1) : extras.front();
    return fmt::format("'{}' is an unexpected argument: {} takes {}; {}", word, command.get_name(),
                       taken, help);
  }
  const std::string name = option->substr(0, option->find('='));
  if (names_a_file(*option)) {
    return fmt::format("{0} is not an option{1}; for a file write ./{0}", *option, of);
  }
  const auto known = meant(name, option_names(command));
  return fmt::format("{} is not an option{}; {}{}", name, of,
                     known ? "did you mean " + *known + "? " : "", help);
}

}  // namespace

std::optional<std::string> refused_command(const CommandLine& line, std::span<char* const> words) {
  const std::string available = problems::enumeration(command_names(line));
  if (words.size() < 2) {
    return fmt::format("a command is missing; available are {}; 'cognate --help' says more",
                       available);
  }
  const std::string word = words[1];
  const auto named = [&](const CLI::App* command) { return command->get_name() == word; };
  if (word.starts_with('-') || !line.app.get_subcommands(named).empty()) return std::nullopt;
  return fmt::format("'{}' is not a command; {}; available are {}", word, advice(line, word),
                     available);
}

std::string refusal_of(const CLI::ParseError& error, const CommandLine& line) {
  const auto called = line.app.get_subcommands();
  const CLI::App& command = called.empty() ? line.app : *called.front();
  const std::string name = called.empty() ? "" : " " + command.get_name();
  const std::string help = fmt::format("'cognate{} --help' says what is allowed", name);
  const auto extras = line.app.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extras.empty()) {
    return refusal_of_extra(command, extras, help);
  }
  const bool required = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  // An unknown option in front keeps the command from being seen, one in its place the file.
  if (required && !extras.empty()) return refusal_of_extra(command, extras, help);
  if (called.empty() && required) {
    return fmt::format("a command is missing; available are {}; 'cognate --help' says more",
                       problems::enumeration(command_names(line)));
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const std::string_view what = error.what();
    return fmt::format("{} needs a value; {}", what.substr(0, what.find(':')), help);
  }
  return fmt::format("{}; {}", error.what(), help);
}

}  // namespace cognate::app
