/// @file Standard output and standard error as they really are: a terminal, a pipe, a full disk, or
/// closed.
#pragma once

#include <string_view>
#include <system_error>

namespace cognate::app {

/// Whether a colour may be used on standard output: it is a terminal that is not `dumb`, and
/// NO_COLOR is not set to anything.
bool colour_on_standard_output();

/// Whether standard error is a terminal on which a line can be overwritten.
bool error_is_terminal();

/// Keeps a file that is opened later from becoming standard input, output or error where the caller
/// closed one of these. Writing to a closed one then still fails. To be called first.
void hold_standard_descriptors();

/// Writes all of `text` to standard output, past every buffer; the error says why it could not.
std::error_code write_standard_output(std::string_view text);

/// Writes `text` to standard error. There is nobody to tell when that fails.
void write_standard_error(std::string_view text);

}  // namespace cognate::app
