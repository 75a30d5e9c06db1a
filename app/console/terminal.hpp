/// @file Standard output and standard error as they really are: a terminal, a pipe, a full disk, or
/// closed.
#pragma once

#include <cstddef>
#include <string_view>
#include <system_error>

#include "app/console/screen.hpp"

namespace cognate::app {

/// What standard output is. It has colours where it is a terminal that is not `dumb` and NO_COLOR
/// is not set to anything, and the width of a terminal alone.
Screen standard_output();

/// The columns of the terminal on standard error.
std::size_t error_width();

/// Whether standard error is a terminal on which a line can be overwritten.
bool error_is_terminal();

/// Keeps a file that is opened later from becoming standard input, output or error where the caller
/// closed one of these. Writing to a closed one then still fails. To be called first.
void hold_standard_descriptors();

/// Whether text is taken at once by standard error: not where a terminal has been stopped (Ctrl-S)
/// or nobody reads a pipe that is full.
bool error_takes_text();

/// Writes all of `text` to standard output, past every buffer; the error says why it could not.
std::error_code write_standard_output(std::string_view text);

/// Writes `text` to standard error. A failure is ignored.
void write_standard_error(std::string_view text);

}  // namespace cognate::app
