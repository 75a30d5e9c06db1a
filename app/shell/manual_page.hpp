/// @file The manual page, cognate(1).
#pragma once

#include <string>
#include <string_view>

#include "app/commands/command_tree.hpp"

namespace cognate::app {

/// The page of the program with a section for each command, as source for `man`.
std::string manual_page(const CommandTree& tree, std::string_view version);

}  // namespace cognate::app
