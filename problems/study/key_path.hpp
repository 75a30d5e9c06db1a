/// @file Places in a document by the names and numbers that lead there.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/study/study.hpp"
#include "problems/toml/document.hpp"

namespace cognate::problems::reading {

/// The path written as "target.points[2][0]", entries counted from 0; empty where that is none.
std::optional<KeyPath> parse_key_path(std::string_view text);

/// What is at `path`; null where nothing is.
Node* find_node(Table& document, const KeyPath& path);

bool is_number(const Node& node);

/// Whether `node` is a string that stands for a number, "7/8".
bool is_expression(const Node& node);

/// Where every number of `document` stands, as `parse_key_path` reads it, the first 10000 of them.
std::vector<std::string> number_keys(const Table& document);

/// Why `path` leads to no number of `document`: "has no key \"x\" in [mechanism]".
std::string misfit(const Table& document, const KeyPath& path);

}  // namespace cognate::problems::reading
