/// @file What text is written for, and how it is fitted to that.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace cognate::app {

/// A terminal of some width, or a file or pipe that takes lines of any length.
struct Screen {
  static constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

  bool colour = false;
  std::size_t width = kUnlimited;  ///< columns
  std::string length{};            ///< the unit of lengths; empty where it is not known
};

/// How many columns of a terminal `text` takes: East-Asian characters take two, combining marks and
/// the escapes of colours none. Text is UTF-8.
std::size_t display_width(const std::string& text);

/// `text` with lines that are too wide for `screen` broken between words; what is broken off is set
/// in below its line.
std::string fitted(const std::string& text, const Screen& screen);

}  // namespace cognate::app
