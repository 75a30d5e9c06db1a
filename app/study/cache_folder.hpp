/// @file Where the program keeps what is the same in every run.
#pragma once

#include <filesystem>

namespace cognate::app {

/// `$XDG_CACHE_HOME/cognate`, `$HOME/.cache/cognate` where that is not set (`%LOCALAPPDATA%` for
/// lack of both); empty where there is no such folder of the user's. It need not exist.
std::filesystem::path cache_folder();

}  // namespace cognate::app
