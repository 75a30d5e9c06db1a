/// @file What is said of a command line that cannot be understood.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/commands/command_line.hpp"

namespace cognate::app {

/// What to say where the words of a command line, the program's name first, do not begin with a
/// command or an option; nothing where they do.
std::optional<std::string> refused_command(const CommandLine& line, std::span<char* const> words);

/// What to say where parsing ended with `error`: what is wrong, and what may have been meant.
std::string refusal_of(const CLI::ParseError& error, const CommandLine& line);

}  // namespace cognate::app
