#include "problems/study/key_path.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

#include "problems/toml/expression.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::size_t kMostKeys = 10000;

bool is_bare(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

// Takes a name off the front of `text`; empty where there is none.
std::string take_name(std::string_view& text) {
  const auto end = std::ranges::find_if_not(text, is_bare);
  std::string name(text.begin(), end);
  text.remove_prefix(name.size());
  return name;
}

// Takes "[12]" off the front of `text`, the one spelling of each number.
std::optional<std::size_t> take_index(std::string_view& text) {
  const auto end = text.find(']');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view digits = text.substr(1, end - 1);
  std::size_t index = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  const bool whole = error == std::errc{} && stop == digits.data() + digits.size();
  if (!whole || fmt::format("{}", index) != digits) return std::nullopt;
  text.remove_prefix(end + 1);
  return index;
}

// What is under `part` of `node`; null where nothing is.
const Node* child(const Table& table, const std::string& key) {
  const auto found = std::ranges::find(table, key, &Entry::key);
  return found == table.end() ? nullptr : &found->node;
}

const Node* child(const Node& node, const KeyPath::value_type& part) {
  if (const auto* key = std::get_if<std::string>(&part)) {
    const auto* table = std::get_if<Table>(&node.value);
    return table ? child(*table, *key) : nullptr;
  }
  const auto* array = std::get_if<Array>(&node.value);
  const std::size_t index = std::get<std::size_t>(part);
  return array && index < array->size() ? &(*array)[index] : nullptr;
}

std::string joined(const std::string& path, const KeyPath::value_type& part) {
  if (const auto* index = std::get_if<std::size_t>(&part))
    return fmt::format("{}[{}]", path, *index);
  const auto& key = std::get<std::string>(part);
  return path.empty() ? key : path + '.' + key;
}

void collect(const Node& node, const std::string& path, std::vector<std::string>& keys);

void collect(const Table& table, const std::string& path, std::vector<std::string>& keys) {
  for (const Entry& entry : table) {
    if (std::ranges::all_of(entry.key, is_bare)) collect(entry.node, joined(path, entry.key), keys);
  }
}

void collect(const Node& node, const std::string& path, std::vector<std::string>& keys) {
  if (keys.size() >= kMostKeys) return;
  if (is_number(node)) keys.push_back(path);
  if (const auto* table = std::get_if<Table>(&node.value)) collect(*table, path, keys);
  if (const auto* array = std::get_if<Array>(&node.value)) {
    for (std::size_t i = 0; i < array->size(); ++i) collect((*array)[i], joined(path, i), keys);
  }
}

std::string no_child(const Node* node, const std::string& path, const KeyPath::value_type& part) {
  if (const auto* key = std::get_if<std::string>(&part)) {
    const bool table = !node || std::holds_alternative<Table>(node->value);
    if (!table) return fmt::format("{} is {} there", path, type_name(*node));
    return fmt::format("there is no {}{}", in_quotes(*key), path.empty() ? "" : " in " + path);
  }
  const auto* array = node ? std::get_if<Array>(&node->value) : nullptr;
  if (!array) return fmt::format("{} is {} there", path, node ? type_name(*node) : "a table");
  return fmt::format("{} has {} entries there, counted from 0", path, array->size());
}

}  // namespace

std::optional<KeyPath> parse_key_path(std::string_view text) {
  KeyPath path;
  for (bool first = true; first || !text.empty(); first = false) {
    if (!first && text.front() == '[') {
      const auto index = take_index(text);
      if (!index) return std::nullopt;
      path.emplace_back(*index);
      continue;
    }
    if (!first && text.front() != '.') return std::nullopt;
    if (!first) text.remove_prefix(1);
    std::string name = take_name(text);
    if (name.empty()) return std::nullopt;
    path.emplace_back(std::move(name));
  }
  return path;
}

Node* find_node(Table& document, const KeyPath& path) {
  const auto* key = path.empty() ? nullptr : std::get_if<std::string>(&path.front());
  const Node* node = key ? child(document, *key) : nullptr;
  for (std::size_t i = 1; node && i < path.size(); ++i) node = child(*node, path[i]);
  return const_cast<Node*>(node);  // of a document that is not constant
}

bool is_number(const Node& node) {
  return std::holds_alternative<double>(node.value) ||
         std::holds_alternative<std::int64_t>(node.value);
}

bool is_expression(const Node& node) {
  const auto* text = std::get_if<std::string>(&node.value);
  return text && evaluate_expression(*text).has_value();
}

std::vector<std::string> number_keys(const Table& document) {
  std::vector<std::string> keys;
  collect(document, "", keys);
  return keys;
}

std::string misfit(const Table& document, const KeyPath& path) {
  const Node* node = nullptr;
  std::string so_far;
  for (const auto& part : path) {
    const auto* key = std::get_if<std::string>(&part);
    const Node* next = node ? child(*node, part) : child(document, *key);
    if (!next) return no_child(node, so_far, part);
    node = next;
    so_far = joined(so_far, part);
  }
  return fmt::format("{} is {} there", so_far, node ? type_name(*node) : "nothing");
}

}  // namespace cognate::problems::reading
