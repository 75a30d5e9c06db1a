/// @file A problem's document as a page hands it over.
#pragma once

#include <string_view>

#include "problems/toml/document.hpp"

namespace cognate::page {

/// The table that `text` writes: of each value a letter and what it holds, numbers in the order in
/// which they stand in the block (see numbers.hpp). `#` is a number, `i` one that is an integer,
/// `+` and `-` are true and false, `s5:crank` is a text of five bytes, `a2:` an array of the two
/// values behind it, `t1:` a table of one key, which is a text, and its value.
problems::reading::Table document_of(std::string_view text);

}  // namespace cognate::page
