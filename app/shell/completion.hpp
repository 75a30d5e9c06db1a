/// @file Scripts that teach a shell to complete the command line.
#pragma once

#include <string>

#include "app/commands/command_tree.hpp"

namespace cognate::app {

/// For bash 4 and newer: to be read by `source`, or installed in bash-completion/completions.
std::string bash_completion(const CommandTree& tree);

/// For zsh: to be read by `source` after compinit, or installed as `_cognate` in a folder of
/// $fpath.
std::string zsh_completion(const CommandTree& tree);

/// For fish: to be read by `source`, or installed in vendor_completions.d.
std::string fish_completion(const CommandTree& tree);

}  // namespace cognate::app
