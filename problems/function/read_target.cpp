#include "problems/function/read_target.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/function/target/jumps.hpp"
#include "problems/function/target/poles.hpp"
#include "problems/toml/expression.hpp"
#include "problems/toml/interpolation.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kKeys[] = {"function", "table"};

// How finely the domain is searched for values that are not finite.
constexpr int kIntervals = 1000;

bool has_exactly_one(TableReader& target, std::string_view pairs) {
  std::string_view first;
  for (const std::string_view key : {kKeys[0], kKeys[1], pairs}) {
    if (!target.has(key)) continue;
    if (!first.empty()) {
      target.fault(key,
                   fmt::format("is given beside target.{}; expected one of function, table and "
                               "{}",
                               first, pairs));
      return false;
    }
    first = key;
  }
  if (!first.empty()) return true;
  target.fault(
      "function",
      fmt::format("is missing; expected one of function (with domain), table and {}", pairs));
  return false;
}

// Keys that say nothing here are faults rather than ignored.
void refuse(TableReader& target, std::initializer_list<std::string_view> keys,
            std::string_view why) {
  for (const std::string_view key : keys) {
    if (target.has(key)) target.fault(key, fmt::format("is given, but {}; remove it", why));
  }
}

std::optional<Range> read_domain(TableReader& target) {
  constexpr std::string_view kKey = "domain";
  if (!target.has(kKey)) {
    target.fault(kKey, "is missing; expected domain = [x0, x1] with x0 < x1");
    return std::nullopt;
  }
  const auto domain = target.range(kKey, kNumber);
  if (domain && domain->min == domain->max) {
    target.fault(kKey, "is empty; expected [x0, x1] with x0 < x1");
    return std::nullopt;
  }
  return domain;
}

// Whether y goes on to both ends of the domain: a value that holds at an end alone is no function
// to generate.
std::optional<std::string> fault_of_ends(const FunctionOfX& function) {
  const auto& [x0, x1] = function.domain;
  const double last_digits =
      4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(x0), std::abs(x1));
  for (const double jump : find_jumps(function.y, function.domain, kIntervals)) {
    const bool first = jump - x0 <= last_digits;
    if (!first && x1 - jump > last_digits) continue;
    return fmt::format(
        "jumps at the end x = {} of its domain; expected a function that goes on to "
        "both ends of the domain [{}, {}]",
        first ? x0 : x1, x0, x1);
  }
  return std::nullopt;
}

std::optional<FunctionOfX> read_expression(TableReader& target) {
  const auto domain = read_domain(target);
  const auto text = target.text("function");
  if (!text) return std::nullopt;
  const auto y = parse_expression(*text);
  if (!y) {
    target.faults().add(target.where_in_text("function", y.error().position),
                        fmt::format("target.function {}", y.error().message));
    return std::nullopt;
  }
  if (!domain) return std::nullopt;
  FunctionOfX function{.text = *text, .table = {}, .y = *y, .domain = *domain};
  const auto fault = function_fault(function);
  if (!fault) return function;
  target.fault("function", *fault);
  return std::nullopt;
}

std::optional<FunctionOfX> read_table(TableReader& target) {
  constexpr std::string_view kKey = "table";
  constexpr std::string_view kDomain = "domain";
  const auto domain = target.range(kDomain, kNumber);
  const auto rows = target.each_two(kKey, kNumber, "[x, y]", {.min = 3, .of = "rows"});
  bool sorted = true;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!rows[i] || !rows[i - 1] || (*rows[i])[0] > (*rows[i - 1])[0]) continue;
    target.faults().add(
        target.where(kKey, i),
        fmt::format("row {} of target.table has x = {} after {}; expected increasing x", i + 1,
                    (*rows[i])[0], (*rows[i - 1])[0]));
    sorted = false;
  }
  const auto all = all_or_none(rows);
  if (!sorted || !all) return std::nullopt;
  FunctionOfX function;
  for (const auto& [x, y] : *all) function.table.emplace_back(x, y);
  function.domain = {function.table.front().first, function.table.back().first};
  const auto& [first, last] = function.domain;
  if (domain && (domain->min != first || domain->max != last)) {
    target.fault(kDomain, "is given, but the domain of a table is its own x; remove it");
  }
  function.y = interpolate(function.table);
  return function;
}

std::optional<double> read_travel(TableReader& target) {
  constexpr std::string_view kKey = "output_range";
  if (!target.has(kKey)) {
    target.fault(
        kKey,
        "is missing; expected a displacement (or relation = \"angles\" where x is an angle "
        "in radians and y a displacement)");
    return std::nullopt;
  }
  return target.number(kKey, kTravel);
}

std::optional<double> read_sweep(TableReader& target, std::string_view key) {
  if (!target.has(key)) {
    target.fault(key,
                 "is missing; expected an angle in degrees (or relation = \"angles\" where x "
                 "and y are themselves angles in radians)");
    return std::nullopt;
  }
  const auto sweep = target.number(key, kSweep);
  return sweep ? std::optional(radians(*sweep)) : std::nullopt;
}

// With ranges y is spread over the output's: its values at the ends must differ.
void check_spread(TableReader& target, const FunctionOfX& function, std::string_view range) {
  const double first = function.y(function.domain.min);
  const double last = function.y(function.domain.max);
  if (std::abs(last - first) > 1e-12 * std::max(std::abs(first), std::abs(last))) return;
  target.fault(target_key(target),
               fmt::format("is {} at both ends of the domain, so {} has no meaning; "
                           "expected different values, or relation = \"angles\"",
                           first, range));
}

void read_relation(TableReader& target, FunctionOfX& function, bool slider) {
  constexpr std::string_view kRelations[] = {"angles"};
  const std::string_view output = slider ? "output_range" : "output_range_deg";
  if (!target.has("relation")) {
    function.input_range = read_sweep(target, "input_range_deg");
    function.output_range = slider ? read_travel(target) : read_sweep(target, output);
    check_spread(target, function, output);
    return;
  }
  target.choice_of("relation", kRelations);
  refuse(target, {"input_range_deg", output},
         slider ? "with a relation x is the angle and y the displacement"
                : "with a relation x and y are the angles");
  const double sweep = function.domain.max - function.domain.min;
  if (sweep > kTurn * (1 + 1e-12)) {
    target.fault(
        target.has("domain") ? "domain" : "table",
        fmt::format("spans {} radians of the input; with relation = \"angles\" at most one "
                    "turn, 6.283185307179586 radians, is allowed",
                    sweep));
  }
}

std::optional<AnglePairs> read_pairs(TableReader& target, bool slider) {
  refuse(target,
         {"domain", "input_range_deg", slider ? "output_range" : "output_range_deg", "relation"},
         slider ? "pairs are themselves angles and displacements" : "pairs are themselves angles");
  // Derivatives at a pair stand for further pairs.
  const std::size_t fewest = target.has("derivatives") ? 1 : 3;
  const auto rows = target.each_two(slider ? "pairs" : "pairs_deg", slider ? kNumber : kAngle,
                                    slider ? "[input_deg, displacement]" : "[input, output]",
                                    {.min = fewest, .of = "pairs"});
  const auto all = all_or_none(rows);
  if (!all) return std::nullopt;
  AnglePairs pairs;
  bool sound = true;
  for (std::size_t i = 0; i < all->size(); ++i) {
    const auto& [input, output] = (*all)[i];
    pairs.emplace_back(radians(input), slider ? output : radians(output));
    if (kAngle.accepts(input)) continue;
    target.faults().add(target.where("pairs", i),
                        fmt::format("entry {} of target.pairs has the input {}; expected {}", i + 1,
                                    input, kAngle.allowed));
    sound = false;
  }
  return sound ? std::optional(std::move(pairs)) : std::nullopt;
}

}  // namespace

std::string value_in_words(double value) {
  return std::isnan(value) ? "not a number (NaN)" : fmt::format("{}", value);
}

std::optional<std::string> function_fault(const FunctionOfX& function) {
  const auto& [x0, x1] = function.domain;
  for (int i = 0; i <= kIntervals; ++i) {
    const double x = i == kIntervals ? x1 : x0 + (x1 - x0) * i / kIntervals;
    const double y = function.y(x);
    if (std::abs(y) <= kGreatestMagnitude) continue;
    return fmt::format(
        "is {} at x = {}; expected values of magnitude up to 1e100 on the whole "
        "domain [{}, {}]",
        value_in_words(y), x, x0, x1);
  }
  const auto pole = find_pole(function.y, function.domain, kIntervals);
  if (!pole) return fault_of_ends(function);
  return fmt::format(
      "has a pole near x = {:.9g}, where its values grow without bound; expected a "
      "function that is finite on the whole domain [{}, {}]",
      *pole, x0, x1);
}

std::string_view target_key(TableReader& target) {
  for (const std::string_view key : {kKeys[0], kKeys[1]}) {
    if (target.has(key)) return key;
  }
  return kKeys[0];
}

std::string_view pairs_key(MechanismType type) {
  return type == MechanismType::slider_crank ? "pairs" : "pairs_deg";
}

std::optional<FunctionTarget> read_function_target(TableReader& target, MechanismType type) {
  const bool slider = type == MechanismType::slider_crank;
  const std::string_view pairs = pairs_key(type);
  target.know({"function", "table", pairs, "domain", "input_range_deg",
               slider ? "output_range" : "output_range_deg", "relation"});
  if (!has_exactly_one(target, pairs)) return std::nullopt;
  if (target.has(pairs)) {
    auto read = read_pairs(target, slider);
    return read ? std::optional<FunctionTarget>(*std::move(read)) : std::nullopt;
  }
  auto function = target.has("function") ? read_expression(target) : read_table(target);
  if (!function) return std::nullopt;
  read_relation(target, *function, slider);
  return *std::move(function);
}

}  // namespace cognate::problems::reading
