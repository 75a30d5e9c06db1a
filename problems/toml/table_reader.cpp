#include "problems/toml/table_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/toml/expression.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

// Integers of TOML are numbers to us: 1 and 1.0 mean the same.
std::optional<double> as_number(const Node& node) {
  if (const auto* number = std::get_if<double>(&node.value)) return *number;
  if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
    return static_cast<double>(*integer);
  }
  return std::nullopt;
}

}  // namespace

std::string_view type_name(const Node& node) {
  constexpr std::string_view kNames[] = {"a boolean",      "an integer", "a number", "a string",
                                         "a date or time", "an array",   "a table"};
  return kNames[node.value.index()];
}

TableReader::TableReader(const Table& document, FaultList& faults)
    : TableReader(&document, "", {}, faults) {}

TableReader::TableReader(const Table* table, std::string name, Where where, FaultList& faults)
    : table_(table), name_(std::move(name)), where_(where), faults_(&faults) {}

TableReader TableReader::table(std::string_view key) {
  const Node* node = find(key);
  if (!node) return {nullptr, name(key), where_, *faults_};
  const auto* table = std::get_if<Table>(&node->value);
  if (!table) wrong_type(*node, name(key), fmt::format("a table [{}]", name(key)));
  return {table, name(key), node->where, *faults_};
}

std::vector<TableReader> TableReader::tables(std::string_view key, const Count& count) {
  const Array* entries = array(key, count, fmt::format("an array of tables [[{}]]", name(key)));
  if (!entries) return {};
  std::vector<TableReader> readers;
  const std::size_t before = faults_->size();
  for (std::size_t i = 0; i < entries->size() && faults_->size() - before < FaultList::kMost; ++i) {
    const Node& node = (*entries)[i];
    const std::string entry = fmt::format("{}[{}]", name(key), i + 1);
    const auto* table = std::get_if<Table>(&node.value);
    if (table) {
      readers.push_back({table, entry, node.where, *faults_});
    } else {
      wrong_type(node, entry, "a table");
    }
  }
  return readers;
}

std::optional<std::string> TableReader::text(std::string_view key) {
  const Node* node = find(key);
  if (!node) return std::nullopt;
  if (const auto* string = std::get_if<std::string>(&node->value)) return *string;
  wrong_type(*node, name(key), "a string");
  return std::nullopt;
}

std::optional<bool> TableReader::boolean(std::string_view key) {
  const Node* node = find(key);
  if (!node) return std::nullopt;
  if (const auto* value = std::get_if<bool>(&node->value)) return *value;
  wrong_type(*node, name(key), "true or false");
  return std::nullopt;
}

std::optional<int> TableReader::integer(std::string_view key, int min, int max) {
  const Node* node = find(key);
  if (!node) return std::nullopt;
  const std::string wanted = fmt::format("an integer from {} to {}", min, max);
  const auto value = value_at(*node, name(key), wanted);
  if (!value) return std::nullopt;
  if (std::holds_alternative<double>(node->value)) {
    fault(key, fmt::format("is {:#}; expected {}", *value, wanted));
    return std::nullopt;
  }
  const bool is_whole = *value == std::floor(*value);
  if (!is_whole || *value < min || *value > max) {
    fault(key, fmt::format("is {}; expected {}", *value, wanted));
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<double> TableReader::number(std::string_view key, const NumberRule& rule) {
  const Node* node = find(key);
  return node ? number_at(*node, name(key), rule) : std::nullopt;
}

std::optional<double> TableReader::turning_speed(std::string_view key, const NumberRule& rule) {
  const std::string by_minute = fmt::format("{}_rpm", key);
  if (!has(by_minute)) return number(key, rule);
  if (has(key)) {
    fault(by_minute, fmt::format("is given together with {}; expected one of them", name(key)));
  }
  const auto turns = number(by_minute, rule);
  return turns ? std::optional(*turns * (kTurn / 60)) : std::nullopt;
}

bool TableReader::has_speed(std::string_view key) {
  const bool by_second = has(key);
  return has(fmt::format("{}_rpm", key)) || by_second;
}

std::optional<std::size_t> TableReader::choice_of(std::string_view key,
                                                  std::span<const std::string_view> allowed) {
  const auto word = text(key);
  if (!word) return std::nullopt;
  const auto found = std::ranges::find(allowed, *word);
  if (found != allowed.end()) return static_cast<std::size_t>(found - allowed.begin());
  const auto meant = nearest(*word, allowed);
  fault(key, fmt::format("is {}{}; allowed are {}", in_quotes(*word),
                         meant ? fmt::format(", perhaps for {}", in_quotes(*meant)) : "",
                         quoted_list(allowed)));
  return std::nullopt;
}

bool TableReader::has(std::string_view key) {
  return find(key) != nullptr;
}

bool TableReader::has_text(std::string_view key) const {
  const Node* node = peek(key);
  return node && std::holds_alternative<std::string>(node->value);
}

bool TableReader::has_word(std::string_view key, std::string_view word) const {
  const Node* node = peek(key);
  const auto* entries = node ? std::get_if<Array>(&node->value) : nullptr;
  return entries && std::ranges::any_of(*entries, [&](const Node& entry) {
           const auto* string = std::get_if<std::string>(&entry.value);
           return string && *string == word;
         });
}

bool TableReader::has_table(std::string_view key) const {
  const Node* node = peek(key);
  return node && std::holds_alternative<Table>(node->value);
}

bool TableReader::has_array(std::string_view key) const {
  const Node* node = peek(key);
  return node && std::holds_alternative<Array>(node->value);
}

Where TableReader::where(std::string_view key) const {
  const Node* node = peek(key);
  return node ? node->where : where_;
}

Where TableReader::where(std::string_view key, std::size_t index) const {
  const Node* node = peek(key);
  const auto* entries = node ? std::get_if<Array>(&node->value) : nullptr;
  return entries && index < entries->size() ? (*entries)[index].where : where(key);
}

Where TableReader::where_in_text(std::string_view key, std::size_t offset) const {
  const Node* node = peek(key);
  const auto* string = node ? std::get_if<std::string>(&node->value) : nullptr;
  Where place = where(key);
  if (!string || !node->verbatim) return place;
  ++place.column;  // the quotation mark
  for (const char c : std::string_view(*string).substr(0, offset)) {
    if ((static_cast<unsigned char>(c) & 0xc0U) != 0x80U) ++place.column;
  }
  return place;
}

std::string TableReader::name(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

void TableReader::fault(std::string_view key, std::string_view rest) {
  faults_->add(where(key), fmt::format("{} {}", name(key), rest));
}

void TableReader::know(std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) find(key);
}

void TableReader::finish() {
  if (!table_) return;
  const std::vector<std::string_view> known(known_.begin(), known_.end());
  const std::size_t before = faults_->size();
  for (const Entry& entry : *table_) {
    if (std::ranges::find(known, entry.key) != known.end()) continue;
    if (faults_->size() - before == FaultList::kMost) break;
    const auto meant = nearest(entry.key, known);
    const std::string place = name_.empty() ? "" : fmt::format(" in [{}]", name_);
    std::string hint = "no key is allowed here in a file of this kind and type";
    if (meant) {
      hint = fmt::format("did you mean {}?", in_quotes(*meant));
    } else if (!known.empty()) {
      hint = fmt::format("allowed are {}", quoted_list(known));
    }
    faults_->add(entry.where,
                 fmt::format("unknown key {}{}; {}", in_quotes(entry.key), place, hint));
  }
}

const Node* TableReader::find(std::string_view key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
  return peek(key);
}

const Node* TableReader::peek(std::string_view key) const {
  if (!table_) return nullptr;
  const auto found = std::ranges::find(*table_, key, &Entry::key);
  return found == table_->end() ? nullptr : &found->node;
}

void TableReader::wrong_type(const Node& node, const std::string& name, std::string_view wanted) {
  faults_->add(node.where, fmt::format("{} is {}; expected {}", name, type_name(node), wanted));
}

std::optional<double> TableReader::value_at(const Node& node, const std::string& name,
                                            std::string_view wanted) {
  if (const auto number = as_number(node)) return number;
  const auto* text = std::get_if<std::string>(&node.value);
  if (!text) {
    wrong_type(node, name, wanted);
    return std::nullopt;
  }
  const auto value = evaluate_expression(*text);
  if (value) return *value;
  const std::string quoted = in_quotes(*text);
  const std::string& message = value.error().message;
  const std::string why =
      message.substr(0, std::min(message.find("; known are "), message.find("; expected ")));
  const bool is_word = why.find(quoted) != std::string::npos;
  faults_->add(node.where, fmt::format("{} is {}{}; expected {}", name, quoted,
                                       is_word ? "" : ", which " + why, wanted));
  return std::nullopt;
}

std::optional<double> TableReader::number_at(const Node& node, const std::string& name,
                                             const NumberRule& rule) {
  const auto value = value_at(node, name, rule.allowed);
  if (!value) return std::nullopt;
  if (!rule.accepts(*value)) {
    faults_->add(node.where, fmt::format("{} is {}; expected {}", name, *value, rule.allowed));
    return std::nullopt;
  }
  return value;
}

TableReader& holder(std::string_view key, TableReader& first, TableReader& second) {
  const bool in_first = first.has(key);
  const bool in_second = second.has(key);
  if (in_first && in_second) {
    second.fault(key, fmt::format("is given a second time; give {} or {}, not both",
                                  first.name(key), second.name(key)));
  }
  return in_second && !in_first ? second : first;
}

}  // namespace cognate::problems::reading
