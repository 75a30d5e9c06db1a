/// @file Which known word an unknown one was probably meant to be.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cognate::problems::reading {

/// The least number of insertions, deletions, replacements and swaps of neighbouring characters
/// that turns `a` into `b` (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of `known` nearest to `word`, the first of equals, unless none is near enough to have
/// been meant: at most two fifths of the longer word's characters may differ, one in any case.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> known);

/// `"a", "b", "c"`.
std::string quoted_list(std::span<const std::string_view> words);

/// `"word"`, shortened in the middle of a message where it is very long, control characters
/// replaced.
std::string in_quotes(std::string_view word);

}  // namespace cognate::problems::reading
