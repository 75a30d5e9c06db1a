/// @file What must hold of a file's bytes before they are parsed as TOML.
#pragma once

#include <optional>
#include <string_view>

#include "problems/toml/fault.hpp"

namespace cognate::problems::reading {

/// The first byte that makes `text` no text: a NUL or another control character that is neither a
/// tab nor the end of a line, or a sequence that is not UTF-8. Empty where there is none.
std::optional<Fault> check_is_text(std::string_view text);

/// The first key of more than 16 dotted parts, `a.b.c…`. The TOML parser limits the nesting of
/// arrays and inline tables itself, but not this one, and each part costs it a stack frame.
std::optional<Fault> check_key_depth(std::string_view text);

}  // namespace cognate::problems::reading
