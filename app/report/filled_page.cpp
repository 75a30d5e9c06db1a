#include "app/report/filled_page.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "problems/linkage/cycle/cycle_quantities.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// How many characters of a member of the result that the page draws from elsewhere it takes.
constexpr std::size_t kLarge = 400'000;

/// JSON that may stand in a script element: ASCII alone, so no U+2028, and every '<' escaped, so no
/// text in it can end the element or open a comment.
std::string embedded(const ordered_json& value) {
  using Handler = ordered_json::error_handler_t;
  std::string text;
  for (const char c : value.dump(-1, ' ', true, Handler::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

/// "torque_ripple_max=N m;…": limits over the cycle that have a unit of their own, with it.
std::string limit_units() {
  std::string text;
  for (const problems::CycleDeclaration& quantity : problems::kCycleQuantities) {
    if (!quantity.is_in_metres()) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : ";", quantity.limit_key, quantity.unit);
  }
  return text;
}

}  // namespace

std::string filled_page(std::string page, const ordered_json& data, std::string_view length_unit) {
  constexpr std::string_view kRoot = "<html", kMarker = "@DATA@";
  std::string attributes;
  if (!length_unit.empty()) attributes = fmt::format(R"( data-length-unit="{}")", length_unit);
  attributes += fmt::format(R"( data-limit-units="{}")", limit_units());
  page.insert(page.find(kRoot) + kRoot.size(), attributes);
  return page.replace(page.find(kMarker), kMarker.size(), embedded(data));
}

std::string without_kernel(std::string page, std::string_view name) {
  const std::string before = fmt::format(R"(id="{}">)", name);
  const auto begin = page.find(before) + before.size();
  return page.erase(begin, page.find('<', begin) - begin);
}

bool is_large(const ordered_json& table, const char* member) {
  using Handler = ordered_json::error_handler_t;
  return table.contains(member) &&
         table[member].dump(-1, ' ', true, Handler::replace).size() > kLarge;
}

void erase_large(ordered_json& table, const char* member) {
  if (is_large(table, member)) table.erase(member);
}

}  // namespace cognate::app
