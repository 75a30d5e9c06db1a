#include "app/commands/command_tree.hpp"

#include <sstream>
#include <utility>

#include "app/commands/command_line.hpp"

namespace cognate::app {
namespace {

/// "dxf|svg|csv" in its parts; nothing of a word that only says what kind of value follows.
std::vector<std::string> values_in(const std::string& argument) {
  std::vector<std::string> values;
  if (argument.find('|') == std::string::npos) return values;
  std::istringstream parts(argument);
  for (std::string part; std::getline(parts, part, '|');) values.push_back(part);
  return values;
}

OptionWords words_of(const CLI::Option& option) {
  OptionWords words{.meaning = option.get_description()};
  for (const auto& name : option.get_snames()) words.names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) words.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) {
    words.argument = option.get_type_name();
    words.values = values_in(words.argument);
  }
  return words;
}

CommandWords words_of(const CLI::App& app) {
  CommandWords words{
      .name = app.get_name(), .purpose = app.get_description(), .more = app.get_footer()};
  for (const CLI::Option* option : app.get_options({})) {
    if (option->get_positional()) {
      words.argument = option->get_name(true);
      words.argument_meaning = option->get_description();
      words.takes_several = option->get_items_expected_max() > 1;
      words.argument_values = values_in(option->get_type_name());
    } else {
      words.options.push_back(words_of(*option));
    }
  }
  return words;
}

}  // namespace

CommandTree command_tree(const CommandLine& line) {
  CommandTree tree{.program = words_of(line.app)};
  for (const CLI::App* command : line.app.get_subcommands([](const CLI::App*) { return true; })) {
    auto words = words_of(*command);
    const auto endings = line.endings.find(words.name);
    if (endings != line.endings.end()) words.endings = endings->second;
    const auto following = line.words.find(words.name);
    if (following != line.words.end()) words.argument_values = following->second;
    (command->get_group().empty() ? tree.hidden : tree.commands).push_back(std::move(words));
  }
  return tree;
}

std::vector<CommandWords> CommandTree::all_commands() const {
  auto all = commands;
  all.insert(all.end(), hidden.begin(), hidden.end());
  return all;
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
  std::string text;
  for (const auto& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

}  // namespace cognate::app
