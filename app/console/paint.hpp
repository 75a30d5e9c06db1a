/// @file Colours of text on a terminal.
#pragma once

#include <fmt/core.h>

#include <string>

namespace cognate::app {

enum class Colour { red = 31, green = 32, yellow = 33, bold = 1 };

/// `text` in `colour` by ANSI escapes, or as it is where `use` is false.
inline std::string paint(const std::string& text, Colour colour, bool use) {
  return use ? fmt::format("\x1b[{}m{}\x1b[0m", static_cast<int>(colour), text) : text;
}

}  // namespace cognate::app
