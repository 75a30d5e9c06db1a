/// @file The values of the command line's options, and what each may be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "problems/basics/length_unit.hpp"

namespace cognate::app {

/// Options common to all commands.
struct Options {
  bool json = false;
  bool quiet = false;
  std::uint64_t seed = 1;
  int threads = 0;                   ///< 0: as many as the machine has
  std::optional<double> time_limit;  ///< seconds
  std::optional<std::filesystem::path> out;
  std::optional<int> steps;                         ///< of the table of a cam over its turn
  std::optional<problems::LengthUnit> length_unit;  ///< of files that give none
};

/// The errors of these say what is wrong with the text and what is allowed.

/// A whole number from 0 to 2⁵³ − 1, which every reader of JSON takes exactly.
tl::expected<std::uint64_t, std::string> parse_seed(std::string_view text);

/// A whole number from 1 to 1024.
tl::expected<int, std::string> parse_threads(std::string_view text);

/// Seconds: more than 0, at most 10⁹.
tl::expected<double, std::string> parse_time_limit(std::string_view text);

/// A whole number from 1 to 100 000.
tl::expected<int, std::string> parse_steps(std::string_view text);

/// A whole number from 1 to 1 000 000.
tl::expected<int, std::string> parse_sample(std::string_view text);

/// One of the words of `length_unit`.
tl::expected<problems::LengthUnit, std::string> parse_length_unit(std::string_view text);

/// The name of a folder: not empty.
tl::expected<std::filesystem::path, std::string> parse_folder(std::string_view text);

}  // namespace cognate::app
