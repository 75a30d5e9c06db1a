/// @file Messages to the user that more than one command gives.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "problems/toml/fault.hpp"

namespace cognate::app {

enum ExitStatus : int {
  exit_done = 0,       ///< done; for `solve`: a design meets every constraint
  exit_no_design = 1,  ///< well posed, and no design meets every constraint
  exit_bad_input = 2,  ///< bad options, a bad file, or a place that cannot be written to
  exit_own_fault = 3,  ///< a fault of Cognate's own
};

/// `text` with every control character replaced by '?', so that a file's text cannot move the
/// cursor or change colours. Text is UTF-8.
std::string printable(std::string_view text);

/// `what` behind the title of a file, where it has one.
std::string titled(const std::string& title, const std::string& what);

/// One line for each fault: `FILE:LINE:COLUMN: what is wrong; what is allowed`.
std::string fault_lines(const std::filesystem::path& file,
                        const std::vector<problems::Fault>& faults);

/// Says `message` on standard error, after the program's name.
void complain(std::string_view message);

/// Writes `text` to standard output. Where that fails says so, and the status is that of bad input.
ExitStatus print(std::string_view text);

}  // namespace cognate::app
