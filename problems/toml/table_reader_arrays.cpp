/// Arrays of a table: of numbers, points, rows and words.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

std::string entry_name(std::size_t index, const std::string& name) {
  return fmt::format("entry {} of {}", index + 1, name);
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

}  // namespace cognate::problems::reading
