#include "problems/study/read_filters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/toml/expression.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kNumberForm =
    "expected [min, max], {min = x} or {max = x}, inf for no limit";
constexpr std::string_view kWordForm = "expected a word, a list of words, true or false";

class FilterReader {
 public:
  FilterReader(const StudyNames& names, FaultList& faults) : names_(names), faults_(faults) {}

  void read(const Table& table, const std::string& prefix) {
    for (const Entry& entry : table) read(entry, prefix + entry.key);
  }

  std::vector<StudyFilter> filters;

 private:
  void read(const Entry& entry, const std::string& name) {
    const auto* table = std::get_if<Table>(&entry.node.value);
    const auto kind = names_.find(name);
    const bool inner = table && !table->empty() && !is_limits(*table);
    if (inner && (!kind || *kind == NameKind::either)) {
      read(*table, name + '.');
    } else if (!kind) {
      faults_.add(entry.where,
                  fmt::format("filter on {}, which is neither a metric of the base nor "
                              "varied; {}",
                              in_quotes(name), names_.hint(name)));
    } else if (auto filter = read_value(entry.node, name, *kind)) {
      filter->name = name;
      filters.push_back(*std::move(filter));
    }
  }

  static bool is_limits(const Table& table) {
    return std::ranges::all_of(table, [](const Entry& entry) {
      return (entry.key == "min" || entry.key == "max") &&
             !std::holds_alternative<Table>(entry.node.value) &&
             !std::holds_alternative<Array>(entry.node.value);
    });
  }

  std::optional<StudyFilter> read_value(const Node& node, const std::string& name, NameKind kind) {
    const auto* array = std::get_if<Array>(&node.value);
    const bool single =
        std::holds_alternative<std::string>(node.value) || std::holds_alternative<bool>(node.value);
    // Strings in the limits of a number are expressions.
    const bool words =
        kind != NameKind::number && array && std::ranges::any_of(*array, [](const Node& entry) {
          return std::holds_alternative<std::string>(entry.value);
        });
    const bool word = single || words;
    if (word && kind == NameKind::number) {
      return wrong(node, fmt::format("{} is a number; {}", in_quotes(name), kNumberForm));
    }
    if (!word && kind == NameKind::word) {
      return wrong(node, fmt::format("{} is a word; {}", in_quotes(name), kWordForm));
    }
    return word ? read_words(node, name) : read_limits(node, name);
  }

  std::optional<StudyFilter> read_words(const Node& node, const std::string& name) {
    StudyFilter filter;
    if (const auto* word = std::get_if<std::string>(&node.value)) filter.words = {*word};
    if (const auto* truth = std::get_if<bool>(&node.value)) {
      filter.words = {*truth ? "true" : "false"};
    }
    if (const auto* array = std::get_if<Array>(&node.value)) {
      for (const Node& entry : *array) {
        const auto* word = std::get_if<std::string>(&entry.value);
        if (!word)
          return wrong(entry, fmt::format("the filter on {} has {} among its words; {}",
                                          in_quotes(name), type_name(entry), kWordForm));
        filter.words.push_back(*word);
      }
    }
    return filter;
  }

  std::optional<StudyFilter> read_limits(const Node& node, const std::string& name) {
    StudyFilter filter;
    const auto* table = std::get_if<Table>(&node.value);
    if (table && !table->empty()) {
      for (const Entry& entry : *table) {
        double* side = entry.key == "min"   ? &filter.min
                       : entry.key == "max" ? &filter.max
                                            : nullptr;
        if (!side) return wrong(entry.where, not_limits(name));
        if (!read_limit(entry.node, name, *side)) return std::nullopt;
      }
    } else if (const auto* array = std::get_if<Array>(&node.value); array && array->size() == 2) {
      const bool both =
          read_limit((*array)[0], name, filter.min) && read_limit((*array)[1], name, filter.max);
      if (!both) return std::nullopt;
    } else {
      return wrong(node, not_limits(name));
    }
    if (filter.min <= filter.max && filter.min < kInfinity && filter.max > -kInfinity) {
      return filter;
    }
    return wrong(
        node, fmt::format("the filter on {} lets nothing pass, from {} to {}; expected min <= max",
                          in_quotes(name), filter.min, filter.max));
  }

  bool read_limit(const Node& node, const std::string& name, double& limit) {
    if (const auto* number = std::get_if<double>(&node.value)) {
      limit = *number;
    } else if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
      limit = static_cast<double>(*integer);
    } else if (const auto* text = std::get_if<std::string>(&node.value)) {
      limit = evaluate_expression(*text).value_or(std::numeric_limits<double>::quiet_NaN());
    } else {
      limit = std::numeric_limits<double>::quiet_NaN();
    }
    if (!std::isnan(limit)) return true;
    wrong(node, not_limits(name));
    return false;
  }

  static std::string not_limits(const std::string& name) {
    return fmt::format("the filter on {} has no limits that are numbers; {}", in_quotes(name),
                       kNumberForm);
  }

  std::nullopt_t wrong(const Node& node, std::string message) {
    return wrong(node.where, std::move(message));
  }
  std::nullopt_t wrong(Where where, std::string message) {
    faults_.add(where, std::move(message));
    return std::nullopt;
  }

  const StudyNames& names_;
  FaultList& faults_;
};

}  // namespace

std::vector<StudyFilter> read_filters(const Table& table, const StudyNames& names,
                                      FaultList& faults) {
  FilterReader reader(names, faults);
  reader.read(table, "");
  return std::move(reader.filters);
}

}  // namespace cognate::problems::reading
