#include "problems/machine/read_function.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/function/read_target.hpp"
#include "problems/machine/expression_jumps.hpp"
#include "problems/machine/periodic_table.hpp"
#include "problems/mechanism/drive_angle.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/derivative.hpp"
#include "problems/toml/expression.hpp"

namespace cognate::problems::reading {
namespace {

// How finely a turn is searched for values that cannot be used.
constexpr int kIntervals = 7200;

// What is smaller is as good as nothing.
constexpr double kLeast = 1e-30;

// The least distance of rows, so that a slope between them is one of the table and not of rounding;
// and by what part of it the difference of two angles may be off.
constexpr double kLeastDegrees = 1e-6;
constexpr double kRounding = 1e-3;

constexpr NumberRule kInertiaRule{is_positive_quantity, "an inertia from 1e-30 to 1e30"};

constexpr std::string_view kVariables[] = {"phi", "w", "t", "s", "v"};

std::span<const std::string_view> variables_of(FunctionOf of) {
  const std::size_t count = of == FunctionOf::phi ? 1 : of == FunctionOf::motion ? 3 : 5;
  return std::span(kVariables).first(count);
}

const NumberRule& values_of(const FunctionRule& rule) {
  return rule.positive ? kInertiaRule : kQuantity;
}

ReadFunction constant(double value) {
  MachineFunction function;
  function.value = [value](double, double, double) { return value; };
  function.slope = [](double) { return 0.0; };
  return {std::move(function)};
}

// Whether a function of the angle alone can be used all the way round.
bool check_turn(TableReader& table, std::string_view key, const FunctionRule& rule,
                const MachineFunction& function) {
  const NumberRule& values = values_of(rule);
  for (int i = 0; i < kIntervals; ++i) {
    const double value = function.value(kTurn * i / kIntervals, 1, 0);
    if (values.accepts(value) || (!rule.positive && std::abs(value) < kLeast)) continue;
    table.fault(key, fmt::format("is {} at phi = {:.6g} ({:.6g} degrees); expected {} everywhere",
                                 value_in_words(value), kTurn * i / kIntervals,
                                 360.0 * i / kIntervals, values.allowed));
    return false;
  }
  if (!rule.positive || function.breaks.empty()) return true;
  table.fault(key, fmt::format("jumps at phi = {:.6g} ({:.6g} degrees), where the energy would "
                               "jump, too; expected an inertia without jumps",
                               function.breaks.front(), function.breaks.front() * 360 / kTurn));
  return false;
}

// An expression's function of phi, w and t; where it names s or v it is of no use.
MachineFunction function_of(const std::string& text, const ParsedExpression& parsed) {
  MachineFunction function;
  function.text = text;
  const auto uses = [&](std::size_t i) { return i < parsed.uses.size() && parsed.uses[i]; };
  function.of_phi = uses(0) || uses(3) || uses(4);
  function.of_speed = uses(1) || uses(4);
  function.of_time = uses(2);
  function.value = [value = parsed.value](double phi, double omega, double time) {
    const std::array<double, 5> values{within_turn(phi), omega, time, 0, 0};
    return value(values);
  };
  return function;
}

std::optional<ReadFunction> read_expression(TableReader& table, std::string_view key,
                                            const FunctionRule& rule) {
  const auto text = table.text(key);
  if (!text) return std::nullopt;
  const auto parsed = parse_expression(*text, variables_of(rule.of));
  if (!parsed) {
    table.faults().add(table.where_in_text(key, parsed.error().position),
                       fmt::format("{} {}", table.name(key), parsed.error().message));
    return std::nullopt;
  }
  ReadFunction read{function_of(*text, *parsed)};
  if (rule.of == FunctionOf::load && (parsed->uses[3] || parsed->uses[4])) {
    read.of_travel = [value = parsed->value](double phi, double omega, double time, double travel,
                                             double rate) {
      const std::array<double, 5> values{within_turn(phi), omega, time, travel, rate};
      return value(values);
    };
    read.function.breaks = jumps_of_expression(*text, *parsed);
    return read;
  }
  MachineFunction& function = read.function;
  function.breaks = jumps_of_expression(*text, *parsed);
  const bool of_angle_alone = !function.of_speed && !function.of_time;
  if (of_angle_alone && !check_turn(table, key, rule, function)) return std::nullopt;
  if (rule.positive) {
    function.slope = derivative([value = function.value](double phi) { return value(phi, 1, 0); });
  }
  return read;
}

// Whether the row at `last` degrees says again what that at `first` does.
bool is_whole_turn(double first, double last) {
  return last - first > 360 - kLeastDegrees;
}

// Whether the rows are in order and within a turn; `all` are those that are right.
bool check_rows(TableReader& table, std::string_view key,
                const std::vector<std::optional<Two>>& all) {
  bool sound = true;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (!all[i] || !all[i - 1]) continue;
    if ((*all[i])[0] - (*all[i - 1])[0] >= kLeastDegrees * (1 - kRounding)) continue;
    table.faults().add(
        table.where(key, i),
        fmt::format("row {} of {} has the angle {} after {}; expected increasing angles, "
                    "{} degrees apart at least",
                    i + 1, table.name(key), (*all[i])[0], (*all[i - 1])[0], kLeastDegrees));
    sound = false;
  }
  if (!sound || all.empty() || !all.front() || !all.back()) return sound;
  const auto [first, first_value] = *all.front();
  const auto [last, last_value] = *all.back();
  if (last - first > 360) {
    table.faults().add(table.where(key, all.size() - 1),
                       fmt::format("{} spans {} degrees; expected a turn, 360 degrees, at most",
                                   table.name(key), last - first));
    return false;
  }
  if (is_whole_turn(first, last) && last_value != first_value) {
    table.faults().add(table.where(key, all.size() - 1),
                       fmt::format("the last row of {} is {} a turn after the first, {}; expected "
                                   "the same value, or no such row",
                                   table.name(key), last_value, first_value));
    return false;
  }
  return true;
}

std::optional<ReadFunction> read_table(TableReader& table, std::string_view key,
                                       const FunctionRule& rule, bool smooth) {
  const auto rows = table.each_two(key, kQuantity, "[deg, value]", {2, kMostMachineRows, "rows"});
  bool sound = check_rows(table, key, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i] || values_of(rule).accepts((*rows[i])[1])) continue;
    table.faults().add(table.where(key, i),
                       fmt::format("row {} of {} is {}; expected {}", i + 1, table.name(key),
                                   (*rows[i])[1], values_of(rule).allowed));
    sound = false;
  }
  const auto all = all_or_none(rows);
  if (!sound || !all) return std::nullopt;
  ReadFunction read;
  MachineFunction& function = read.function;
  std::vector<std::pair<double, double>> radian_rows;
  for (const auto& [deg, value] : *all) {
    function.table.emplace_back(deg, value);
    if (is_whole_turn(all->front()[0], deg)) continue;
    radian_rows.emplace_back(radians(deg), value);
    function.breaks.push_back(within_turn(radians(deg)));
  }
  std::ranges::sort(function.breaks);
  function.smooth = smooth;
  function.of_phi = true;
  auto through = periodic(radian_rows, smooth);
  function.value = [value = std::move(through.value)](double phi, double, double) {
    return value(phi);
  };
  function.slope = std::move(through.slope);
  return read;
}

}  // namespace

std::optional<ReadFunction> read_machine_function(TableReader& table, std::string_view key,
                                                  const FunctionRule& rule, bool smooth) {
  if (table.has_text(key)) return read_expression(table, key, rule);
  if (table.has_array(key)) return read_table(table, key, rule, smooth);
  const auto number = table.number(key, values_of(rule));
  return number ? std::optional(constant(*number)) : std::nullopt;
}

bool read_interpolation(TableReader& table, std::initializer_list<std::string_view> tables) {
  constexpr std::string_view kKey = "interpolation";
  constexpr std::string_view kWays[] = {"linear", "smooth"};
  if (!table.has(kKey)) return false;
  const auto way = table.choice_of(kKey, kWays);
  if (std::ranges::none_of(tables, [&](auto key) { return table.has_array(key); })) {
    table.fault(kKey, "is given, but there is no table whose rows it could join; remove it");
  }
  return way == 1;
}

}  // namespace cognate::problems::reading
