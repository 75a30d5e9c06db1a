/// `cognate involute`: the involute function and its inverse, of single values and of ranges.
#include "analysis/gear/involute.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/console/messages.hpp"
#include "app/console/option_text.hpp"
#include "app/console/terminal.hpp"
#include "app/console/text_table.hpp"
#include "app/documents/csv.hpp"
#include "app/documents/result_json.hpp"

namespace cognate::app {
namespace {

using Values = std::vector<double>;
using ValuesOrFault = tl::expected<Values, std::string>;

constexpr std::size_t kMostRows = 100'000;
constexpr const char* kTextbookRange = "10:45:1";

/// What a word of the command line may be.
struct ArgumentRule {
  const char* what;
  double below;  ///< numbers are 0 or more, and less than this
  const char* allowed;
};

constexpr ArgumentRule kAngles{
    "angle", 90, "0 or more and less than 90 degrees, or a range FROM:TO or FROM:TO:STEP of them"};
constexpr ArgumentRule kInvolutes{"involute", HUGE_VAL,
                                  "0 or more, finite, or a range FROM:TO:STEP of such numbers"};

/// The numbers between colons; empty where one is none or is not allowed.
Values numbers_of(std::string_view text, const ArgumentRule& rule) {
  Values numbers;
  for (bool more = true; more;) {
    const std::size_t end = text.find(':');
    more = end != std::string_view::npos;
    const auto number = parse_all<double>(text.substr(0, end));
    if (!number || !(*number >= 0) || !(*number < rule.below)) return {};
    numbers.push_back(*number);
    if (more) text.remove_prefix(end + 1);
  }
  return numbers;
}

/// FROM, FROM + STEP, … up to TO, which is met where a whole number of steps leads there but for
/// rounding.
ValuesOrFault range_of(double from, double to, double step, const std::string& text) {
  const double steps = std::floor((to - from) / step * (1 + 1e-12) + 1e-9);
  if (!(to >= from) || !(step > 0) || !(steps < double(kMostRows))) {
    return tl::unexpected(
        fmt::format("'{}' is no range of at most {} values; allowed is "
                    "FROM:TO:STEP with FROM <= TO and STEP > 0",
                    text, kMostRows));
  }
  Values values;
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    values.push_back(std::min(to, from + i * step));
  }
  return values;
}

ValuesOrFault values_of(const std::string& text, const ArgumentRule& rule) {
  Values numbers = numbers_of(text, rule);
  const bool has_step = rule.below == kAngles.below;  // one degree, if none is given
  if (numbers.size() == 1) return numbers;
  if (numbers.size() == 3) return range_of(numbers[0], numbers[1], numbers[2], text);
  if (numbers.size() == 2 && has_step) return range_of(numbers[0], numbers[1], 1, text);
  return tl::unexpected(
      fmt::format("'{}' is no {}; allowed is {}", printable(text), rule.what, rule.allowed));
}

/// All arguments one after the other, or every fault in them, a line each.
ValuesOrFault all_values(const std::vector<std::string>& texts, const ArgumentRule& rule) {
  Values all;
  for (const std::string& text : texts) {
    const auto values = values_of(text, rule);
    if (!values) return values;
    all.insert(all.end(), values->begin(), values->end());
  }
  if (all.size() > kMostRows) {
    return tl::unexpected(
        fmt::format("{} values are requested; at most {} are allowed", all.size(), kMostRows));
  }
  return all;
}

/// The angles and their involutes, in the order in which they were given.
struct InvoluteTable {
  Values angles, involutes;
};

InvoluteTable table_of(Values given, bool inverse) {
  Values found;
  for (const double value : given) {
    found.push_back(inverse ? gear::involute_angle_in_degrees(value)
                            : gear::involute_of_degrees(value));
  }
  if (inverse) return {std::move(found), std::move(given)};
  return {std::move(given), std::move(found)};
}

std::string csv_of(const InvoluteTable& table) {
  const problems::Column columns[] = {{"angle_deg", "angle", "involute", "deg", table.angles},
                                      {"involute", "involute", "involute", "", table.involutes}};
  return csv_text(columns);
}

std::string text_of(const InvoluteTable& table) {
  Column angles{"angle [deg]", Align::right, {}}, involutes{"inv", Align::right, {}};
  for (std::size_t i = 0; i < table.angles.size(); ++i) {
    angles.cells.push_back(fmt::format("{:.12g}", table.angles[i]));
    involutes.cells.push_back(fmt::format("{:.12g}", table.involutes[i]));
  }
  return table_text({angles, involutes}, standard_output());
}

}  // namespace

ExitStatus involute_command(const std::vector<std::string>& texts, const InvoluteOptions& wanted,
                            const Options& options) {
  if (wanted.inverse && texts.empty()) {
    complain("--inverse: the values of the involute are missing; expected numbers behind it");
    return exit_bad_input;
  }
  const std::vector<std::string> usual = {kTextbookRange};
  const auto values =
      all_values(texts.empty() ? usual : texts, wanted.inverse ? kInvolutes : kAngles);
  if (!values) {
    complain(values.error());
    return exit_bad_input;
  }
  const InvoluteTable table = table_of(*values, wanted.inverse);
  if (options.json) {
    return print(write_json({{"format", "cognate-involute/1"},
                             {"angle_deg", table.angles},
                             {"involute", table.involutes}}));
  }
  if (options.quiet) return exit_done;
  return print(wanted.csv ? csv_of(table) : text_of(table));
}

}  // namespace cognate::app
