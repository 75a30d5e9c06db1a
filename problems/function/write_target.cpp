#include "problems/function/write_target.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "problems/function/read_goal.hpp"

namespace cognate::problems::reading {
namespace {

using Pairs = std::vector<std::pair<double, double>>;

/// A function of the user's own stands in the document by so many of its values.
constexpr int kValuesOfOwn = 257;

Pairs values_of_own(const FunctionOfX& function) {
  Pairs rows;
  const auto& [first, last] = function.domain;
  for (int i = 0; i < kValuesOfOwn; ++i) {
    const double share = static_cast<double>(i) / (kValuesOfOwn - 1);
    const double x = i + 1 == kValuesOfOwn ? last : first + share * (last - first);
    rows.emplace_back(x, function.y(x));
  }
  return rows;
}

/// `function.y` is there.
void write_values(const FunctionOfX& function, bool slider, TableWriter& table) {
  if (!function.text.empty()) {
    table.set("function", function.text);
  } else {
    table.set("table", function.table.empty() ? values_of_own(function) : function.table);
  }
  table.set("domain", function.domain).set_deg("input_range_deg", function.input_range);
  if (slider) {
    table.set("output_range", function.output_range);
  } else {
    table.set_deg("output_range_deg", function.output_range);
  }
  if (!function.input_range && !function.output_range) table.set("relation", "angles");
}

void write_values(const AnglePairs& pairs, bool slider, TableWriter& table) {
  Array rows;
  for (const auto& [input, output] : pairs) {
    rows.push_back(node(Array{node_deg(input), slider ? node(output) : node_deg(output)}));
  }
  table.set(slider ? "pairs" : "pairs_deg", rows);
}

}  // namespace

TableWriter function_target_writer(const FunctionTarget& target,
                                   const std::vector<double>& sample_at, bool slider) {
  TableWriter table;
  std::visit([&](const auto& values) { write_values(values, slider, table); }, target);
  if (!sample_at.empty()) table.set("sample_at", sample_at);
  const auto* function = std::get_if<FunctionOfX>(&target);
  const bool own = function && function->text.empty() && function->table.empty();
  if (own && sample_at.empty()) table.set("samples", kDefaultSamples);
  return table;
}

std::optional<std::string> fault_of_function(const FunctionOfX& function) {
  if (!function.y)
    return "target has no function y(x); expected one in addition to its text or table";
  const auto& [first, last] = function.domain;
  if (!kNumber.accepts(first) || !kNumber.accepts(last) || !(first < last)) {
    return "target.domain is no interval; expected [x0, x1] with x0 < x1";
  }
  if (function.table.empty()) {
    const auto fault = function_fault(function);
    return fault ? std::optional("target.function " + *fault) : std::nullopt;
  }
  for (const auto& [x, given] : values_of_own(function)) {
    if (std::isfinite(given)) continue;
    return fmt::format("target.table is {} at x = {}; expected finite values", given, x);
  }
  return std::nullopt;
}

}  // namespace cognate::problems::reading
