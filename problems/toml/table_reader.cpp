#include "problems/toml/table_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/toml/expression.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

std::string entry_name(std::size_t index, const std::string& name) {
  return fmt::format("entry {} of {}", index + 1, name);
}

// Integers of TOML are numbers to us: 1 and 1.0 mean the same.
std::optional<double> as_number(const Node& node) {
  if (const auto* number = std::get_if<double>(&node.value)) return *number;
  if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
    return static_cast<double>(*integer);
  }
  return std::nullopt;
}

// "pose" of "poses", "entry" of "entries", "kind of dyads" of "kinds of dyads".
std::string singular(std::string_view plural) {
  const auto end = std::min(plural.find(" of "), plural.size());
  const std::string_view word = plural.substr(0, end);
  const bool ies = word.ends_with("ies");
  return fmt::format("{}{}{}", word.substr(0, word.size() - (ies ? 3 : 1)), ies ? "y" : "",
                     plural.substr(end));
}

}  // namespace

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

std::optional<std::vector<std::string>> TableReader::texts(std::string_view key,
                                                           const Count& count) {
  const Array* entries = array(key, count, "an array of strings");
  if (!entries) return std::nullopt;
  std::vector<std::string> all;
  const std::size_t before = faults_->size();
  for (std::size_t i = 0; i < entries->size() && faults_->size() - before < FaultList::kMost; ++i) {
    const Node& node = (*entries)[i];
    if (const auto* string = std::get_if<std::string>(&node.value)) {
      all.push_back(*string);
    } else {
      wrong_type(node, entry_name(i, name(key)), "a string");
    }
  }
  return all.size() == entries->size() ? std::optional(std::move(all)) : std::nullopt;
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
    fault(by_minute, fmt::format("is given besides {}; expected one of them", name(key)));
  }
  const auto turns = number(by_minute, rule);
  return turns ? std::optional(*turns * (kTurn / 60)) : std::nullopt;
}

bool TableReader::has_speed(std::string_view key) {
  const bool by_second = has(key);
  return has(fmt::format("{}_rpm", key)) || by_second;
}

std::vector<std::optional<double>> TableReader::each_number(std::string_view key,
                                                            const NumberRule& rule,
                                                            const Count& count) {
  const Array* entries = array(key, count, "an array of numbers");
  if (!entries) return {};
  std::vector<std::optional<double>> values(entries->size());
  const std::size_t before = faults_->size();
  for (std::size_t i = 0; i < entries->size() && faults_->size() - before < FaultList::kMost; ++i) {
    values[i] = number_at((*entries)[i], entry_name(i, name(key)), rule);
  }
  return values;
}

std::vector<std::optional<double>> TableReader::each_number_or(std::string_view key,
                                                               std::string_view none,
                                                               const NumberRule& rule,
                                                               const Count& count,
                                                               std::vector<bool>& is_number) {
  const Array* entries = array(key, count, fmt::format("an array of numbers and \"{}\"", none));
  if (!entries) return {};
  std::vector<std::optional<double>> values(entries->size());
  is_number.assign(entries->size(), true);
  const std::size_t before = faults_->size();
  for (std::size_t i = 0; i < entries->size() && faults_->size() - before < FaultList::kMost; ++i) {
    const Node& entry = (*entries)[i];
    const auto* word = std::get_if<std::string>(&entry.value);
    is_number[i] = !(word && *word == none);
    values[i] = is_number[i] ? number_at(entry, entry_name(i, name(key)), rule) : 0;
  }
  return values;
}

std::optional<std::vector<double>> TableReader::numbers(std::string_view key,
                                                        const NumberRule& rule,
                                                        const Count& count) {
  return all_or_none(each_number(key, rule, count));
}

std::optional<Two> TableReader::two(std::string_view key, const NumberRule& rule,
                                    std::string_view form) {
  const Node* node = find(key);
  return node ? two_at(*node, name(key), rule, form) : std::nullopt;
}

std::vector<std::optional<Two>> TableReader::each_two(std::string_view key, const NumberRule& rule,
                                                      std::string_view form, const Count& count) {
  const Array* entries = array(key, count, fmt::format("an array of {}", form));
  if (!entries) return {};
  std::vector<std::optional<Two>> values(entries->size());
  const std::size_t before = faults_->size();
  for (std::size_t i = 0; i < entries->size() && faults_->size() - before < FaultList::kMost; ++i) {
    values[i] = two_at((*entries)[i], entry_name(i, name(key)), rule, form);
  }
  return values;
}

std::optional<std::vector<Two>> TableReader::twos(std::string_view key, const NumberRule& rule,
                                                  std::string_view form, const Count& count) {
  return all_or_none(each_two(key, rule, form, count));
}

std::optional<std::vector<std::vector<double>>> TableReader::lists(std::string_view key,
                                                                   const NumberRule& rule,
                                                                   std::string_view form,
                                                                   const Count& count,
                                                                   std::size_t most) {
  const Array* entries = array(key, count, fmt::format("an array of arrays, {},", form));
  if (!entries) return std::nullopt;
  std::vector<std::vector<double>> all;
  const std::size_t before = faults_->size();
  for (std::size_t i = 0; i < entries->size() && faults_->size() - before < FaultList::kMost; ++i) {
    const std::string own = entry_name(i, name(key));
    const auto* list = std::get_if<Array>(&(*entries)[i].value);
    if (!list) {
      wrong_type((*entries)[i], own, "an array of numbers");
      continue;
    }
    if (list->size() > most) {
      faults_->add((*entries)[i].where,
                   fmt::format("{} has {} numbers; expected at most {}", own, list->size(), most));
      continue;
    }
    std::vector<double>& values = all.emplace_back();
    for (std::size_t j = 0; j < list->size(); ++j) {
      const auto value = number_at((*list)[j], entry_name(j, own), rule);
      if (value) values.push_back(*value);
    }
  }
  return faults_->size() == before ? std::optional(std::move(all)) : std::nullopt;
}

std::vector<std::optional<std::vector<double>>> TableReader::each_row(std::string_view key,
                                                                      std::size_t width,
                                                                      const NumberRule& rule,
                                                                      std::string_view form,
                                                                      const Count& count) {
  const Array* entries = array(key, count, fmt::format("an array of {}", form));
  if (!entries) return {};
  std::vector<std::optional<std::vector<double>>> rows(entries->size());
  for (std::size_t i = 0; i < entries->size(); ++i) {
    const std::string row_name = entry_name(i, name(key));
    const Array* row = row_at((*entries)[i], row_name, width, form);
    if (!row) continue;
    std::vector<std::optional<double>> values;
    for (std::size_t k = 0; k < width; ++k) {
      values.push_back(number_at((*row)[k], entry_name(k, row_name), rule));
    }
    rows[i] = all_or_none(values);
  }
  return rows;
}

std::vector<std::optional<std::array<Two, 2>>> TableReader::each_segment(std::string_view key,
                                                                         const NumberRule& rule,
                                                                         std::string_view form,
                                                                         const Count& count) {
  const Array* entries = array(key, count, fmt::format("an array of {}", form));
  if (!entries) return {};
  std::vector<std::optional<std::array<Two, 2>>> segments(entries->size());
  for (std::size_t i = 0; i < entries->size(); ++i) {
    const std::string segment_name = entry_name(i, name(key));
    const Array* ends = row_at((*entries)[i], segment_name, 2, form);
    if (!ends) continue;
    const auto first = two_at((*ends)[0], entry_name(0, segment_name), rule, "[x, y]");
    const auto second = two_at((*ends)[1], entry_name(1, segment_name), rule, "[x, y]");
    if (first && second) segments[i] = {*first, *second};
  }
  return segments;
}

std::optional<Vec2d> TableReader::point(std::string_view key) {
  const auto value = two(key, kNumber, "[x, y]");
  return value ? std::optional(Vec2d{(*value)[0], (*value)[1]}) : std::nullopt;
}

std::optional<Range> TableReader::range(std::string_view key, const NumberRule& rule) {
  const auto ends = two(key, rule, "[min, max]");
  if (!ends) return std::nullopt;
  const Range range{(*ends)[0], (*ends)[1]};
  if (range.min > range.max) {
    fault(key, fmt::format("is empty, {} > {}; expected [min, max] with min <= max", range.min,
                           range.max));
    return std::nullopt;
  }
  return range;
}

std::optional<Box> TableReader::box(std::string_view key) {
  constexpr std::string_view kForm = "[[xmin, ymin], [xmax, ymax]]";
  const auto corners = twos(key, kCoordinateLimit, kForm, {2, 2, "corners"});
  if (!corners) return std::nullopt;
  const Two& min = corners->front();
  const Two& max = corners->back();
  const auto is_empty = [](double low, double high) {
    return low > high || (low == high && std::isinf(low));
  };
  if (is_empty(min[0], max[0]) || is_empty(min[1], max[1])) {
    fault(key, fmt::format("is an empty region; expected {} with min <= max", kForm));
    return std::nullopt;
  }
  return Box{{min[0], min[1]}, {max[0], max[1]}};
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

const Array* TableReader::array(std::string_view key, const Count& count, std::string_view wanted) {
  const Node* node = find(key);
  if (!node) return nullptr;
  const auto* entries = std::get_if<Array>(&node->value);
  if (!entries) {
    wrong_type(*node, name(key), wanted);
    return nullptr;
  }
  if (entries->size() < count.min || entries->size() > count.max) {
    const std::string allowed = count.min == count.max
                                    ? fmt::format("{}", count.min)
                                    : fmt::format("{} to {}", count.min, count.max);
    const std::string of = entries->size() == 1 ? singular(count.of) : std::string(count.of);
    fault(key, fmt::format("has {} {}; expected {}", entries->size(), of, allowed));
    return nullptr;
  }
  return entries;
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

const Array* TableReader::row_at(const Node& node, const std::string& name, std::size_t width,
                                 std::string_view form) {
  const auto* entries = std::get_if<Array>(&node.value);
  if (!entries) {
    wrong_type(node, name, form);
    return nullptr;
  }
  if (entries->size() != width) {
    faults_->add(node.where,
                 fmt::format("{} has {} entries; expected {}", name, entries->size(), form));
    return nullptr;
  }
  return entries;
}

std::optional<Two> TableReader::two_at(const Node& node, const std::string& name,
                                       const NumberRule& rule, std::string_view form) {
  const Array* entries = row_at(node, name, 2, form);
  if (!entries) return std::nullopt;
  const auto first = number_at((*entries)[0], entry_name(0, name), rule);
  const auto second = number_at((*entries)[1], entry_name(1, name), rule);
  return first && second ? std::optional(Two{*first, *second}) : std::nullopt;
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
